// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/llvm/program/imc_mission.h"

#include <llvm/IR/Constants.h>
#include <llvm/IR/DerivedTypes.h>

namespace glider::codegen {

void addImcMission(llvm::Module& module, const GliderImcMission& imc) {
  llvm::LLVMContext& context = module.getContext();
  const auto number = [&](double value) {
    return llvm::ConstantFP::get(llvm::Type::getDoubleTy(context), value);
  };
  const auto word = [&](uint32_t value) {
    return llvm::ConstantInt::get(llvm::Type::getInt32Ty(context), value);
  };
  static_assert(sizeof(GliderImcMission) == 7 * sizeof(double) + 2 * sizeof(uint32_t) +
                                                2 * GLIDER_MOST_IMC_READINGS * sizeof(uint16_t));
  llvm::Constant* value = llvm::ConstantStruct::getAnon(
      context, {number(imc.greatest_depth_m), number(imc.slowest_m_s), number(imc.fastest_m_s),
                number(imc.usual_m_s), number(imc.timeout_s), number(imc.loiter_m),
                number(imc.start_depth_m), word(imc.vehicle), word(imc.count),
                llvm::ConstantDataArray::get(context, imc.sensors),
                llvm::ConstantDataArray::get(context, imc.sources)});
  new llvm::GlobalVariable(module, value->getType(), true, llvm::GlobalValue::ExternalLinkage,
                           value, "gliderImc");
}

}  // namespace glider::codegen
