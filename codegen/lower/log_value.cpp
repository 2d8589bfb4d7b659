// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/lower/body.h"

namespace glider::codegen {
namespace {

llvm::Function* lowerState(Lowering& lowering, const ir::State& state) {
  Body body(lowering, "log." + state.name, Body::Result::Number, 1);
  llvm::IRBuilder<>& builder = body.builder;
  llvm::BasicBlock* none = body.block("none");
  llvm::SwitchInst* choice =
      builder.CreateSwitch(body.function->getArg(1), none, static_cast<unsigned>(state.log.size()));
  builder.SetInsertPoint(none);
  builder.CreateRet(llvm::ConstantFP::getNaN(builder.getDoubleTy()));
  for (uint32_t i = 0; i < state.log.size(); ++i) {
    llvm::BasicBlock* item = body.block("item");
    choice->addCase(builder.getInt32(i), item);
    builder.SetInsertPoint(item);
    body.expressions.forget();
    builder.CreateRet(body.expressions.asNumber(state.log[i].value));
  }
  return body.function;
}

}  // namespace

llvm::Function* lowerLogValue(Lowering& lowering) {
  const auto functions = forEachState(
      lowering, [](const ir::State& state) { return state.log.empty(); },
      [&](uint32_t i) { return lowerState(lowering, lowering.mission.states[i]); });
  Body body(lowering, "log_value", Body::Result::Number, 1);
  returnResult(body, callOfState(body, functions, {body.context(), body.function->getArg(1)}));
  return body.function;
}

}  // namespace glider::codegen
