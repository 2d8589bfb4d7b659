// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/llvm/lower/abi_types.h"

#include <llvm/IR/Type.h>

#include <vector>

namespace glider::codegen {

AbiTypes makeAbiTypes(llvm::LLVMContext& context) {
  AbiTypes types;
  std::vector<llvm::Type*> fields;
#define GLIDER_TYPE_U32 llvm::Type::getInt32Ty(context)
#define GLIDER_TYPE_F64 llvm::Type::getDoubleTy(context)
#define GLIDER_TYPE_PTR(pointee) llvm::PointerType::getUnqual(context)
#define STRUCT(name) fields.clear();
#define FIELD(type, name) fields.push_back(GLIDER_TYPE_##type);
#define STRUCT_END(name) types.name = llvm::StructType::create(context, fields, #name);
#include "hooks/protocol/dictionary.def"
#include "runtime/abi/abi_structs.def"
#undef STRUCT
#undef FIELD
#undef STRUCT_END
  return types;
}

}  // namespace glider::codegen
