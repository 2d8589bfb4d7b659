// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/llvm/program/port_mission.h"

#include <llvm/IR/Constants.h>
#include <llvm/IR/DerivedTypes.h>

#include <cstddef>

namespace glider::codegen {

void addPortMission(llvm::Module& module, const GliderPortMission& port) {
  llvm::LLVMContext& context = module.getContext();
  llvm::Type* real = llvm::Type::getDoubleTy(context);
  llvm::Type* word = llvm::Type::getInt32Ty(context);
  const auto number = [&](double value) { return llvm::ConstantFP::get(real, value); };
  const auto count = [&](uint32_t value) { return llvm::ConstantInt::get(word, value); };
  static_assert(offsetof(GliderPortMission, mission_modes) ==
                4 * sizeof(double) + 4 * sizeof(uint32_t));
  llvm::StructType* type =
      llvm::StructType::get(context, {real, real, real, real, word, word, word, word, word});
  llvm::Constant* value = llvm::ConstantStruct::get(
      type, {number(port.greatest_depth_m), number(port.steepest_pitch_rad),
             number(port.shallowest_pitch_rad), number(port.hold_m), count(port.program),
             count(port.latitude), count(port.longitude), count(port.depth_state),
             count(port.mission_modes)});
  new llvm::GlobalVariable(module, type, true, llvm::GlobalValue::ExternalLinkage, value,
                           "gliderPort");
}

}  // namespace glider::codegen
