// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/llvm/program/seat_constant.h"

#include <llvm/IR/Constants.h>
#include <llvm/IR/DerivedTypes.h>

#include <vector>

namespace glider::codegen {

void addSeatConstant(llvm::Module& module, const char* name, llvm::ArrayRef<double> numbers,
                     llvm::ArrayRef<uint32_t> words, llvm::ArrayRef<uint16_t> sensors,
                     llvm::ArrayRef<uint16_t> sources) {
  llvm::LLVMContext& context = module.getContext();
  std::vector<llvm::Constant*> fields;
  for (const double number : numbers) {
    fields.push_back(llvm::ConstantFP::get(llvm::Type::getDoubleTy(context), number));
  }
  for (const uint32_t word : words) {
    fields.push_back(llvm::ConstantInt::get(llvm::Type::getInt32Ty(context), word));
  }
  fields.push_back(llvm::ConstantDataArray::get(context, sensors));
  fields.push_back(llvm::ConstantDataArray::get(context, sources));
  llvm::Constant* value = llvm::ConstantStruct::getAnon(context, fields);
  new llvm::GlobalVariable(module, value->getType(), true, llvm::GlobalValue::ExternalLinkage,
                           value, name);
}

}  // namespace glider::codegen
