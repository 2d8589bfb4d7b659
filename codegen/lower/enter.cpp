// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/lower/body.h"
#include "runtime/abi/glider_abi.h"

namespace glider::codegen {
namespace {

void enterActivity(Body& body, const ir::Activity& activity, uint32_t memory_block) {
  if (body.lowering.mission[activity.behaviour].symbol.empty()) {
    lowerBlock(body, activity.entry);
  } else {
    callBehaviour(body, activity, memory_block, body.function->getArg(1));
  }
}

/// On enter everything; on resume what lies at `start` and at `fly`.
llvm::Function* lowerState(Lowering& lowering, uint32_t index) {
  const ir::State& state = lowering.mission.states[index];
  Body body(lowering, "enter." + state.name, Body::Result::None, 1, state.name + " begins",
            state.range);
  llvm::IRBuilder<>& builder = body.builder;
  llvm::BasicBlock* fresh = body.block("fresh");
  llvm::BasicBlock* start = body.block("start");
  llvm::BasicBlock* entry = body.block("entry_block");
  llvm::BasicBlock* fly = body.block("fly");
  llvm::Value* entered =
      builder.CreateICmpEQ(body.function->getArg(1), builder.getInt32(kGliderEnter));
  builder.CreateCondBr(entered, fresh, start);
  builder.SetInsertPoint(fresh);
  for (const ir::VariableId variable : lowering.index.state_variables[index]) {
    assign(body, variable, body.expressions.asNumber(lowering.mission[variable].initial));
  }
  builder.CreateBr(start);
  builder.SetInsertPoint(start);
  body.expressions.forget();
  lowerTemporals(body, lowering.index.state_temporals[index], Moment::Start);
  builder.CreateCondBr(entered, entry, fly);
  builder.SetInsertPoint(entry);
  body.expressions.forget();
  lowerBlock(body, state.entry);
  builder.CreateBr(fly);
  builder.SetInsertPoint(fly);
  body.expressions.forget();
  enterActivity(body, state.profile, lowering.index.memory_blocks[index].profile);
  enterActivity(body, state.route, lowering.index.memory_blocks[index].route);
  builder.CreateRetVoid();
  return body.function;
}

}  // namespace

llvm::Function* lowerEnter(Lowering& lowering) {
  const auto functions = forEachState(
      lowering, [](const ir::State&) { return false; },
      [&](uint32_t i) { return lowerState(lowering, i); });
  Body body(lowering, "enter", Body::Result::None, 1);
  returnResult(body, callOfState(body, functions, {body.context(), body.function->getArg(1)}));
  return body.function;
}

}  // namespace glider::codegen
