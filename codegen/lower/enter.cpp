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

/// The variables start, then the temporals, then the state's entry runs.
void enterState(Body& body, uint32_t index) {
  const Lowering& lowering = body.lowering;
  for (const ir::VariableId variable : lowering.index.state_variables[index]) {
    assign(body, variable, body.expressions.asNumber(lowering.mission[variable].initial));
  }
  body.expressions.forget();  // temporals that initial values have read
  lowerTemporals(body, lowering.index.state_temporals[index], Moment::Start);
  lowerBlock(body, lowering.mission.states[index].entry);
}

bool comesWithNothing(const Lowering& lowering, const ir::Activity& activity) {
  return lowering.mission[activity.behaviour].symbol.empty() && !activity.entry.valid();
}

bool hasNothingToDo(const Lowering& lowering, uint32_t index) {
  const ir::State& state = lowering.mission.states[index];
  return lowering.index.state_variables[index].empty() &&
         lowering.index.state_temporals[index].empty() && !state.entry.valid() &&
         comesWithNothing(lowering, state.profile) && comesWithNothing(lowering, state.route);
}

}  // namespace

llvm::Function* lowerEnter(Lowering& lowering, uint32_t index) {
  if (hasNothingToDo(lowering, index)) {
    return nullptr;
  }
  const ir::State& state = lowering.mission.states[index];
  Body body(lowering, "enter." + state.name, Body::Result::None, 1, state.name + " begins",
            state.range);
  llvm::IRBuilder<>& builder = body.builder;
  llvm::BasicBlock* enter = body.block("enter");
  llvm::BasicBlock* resume = body.block("resume");
  llvm::BasicBlock* fly = body.block("fly");
  builder.CreateCondBr(
      builder.CreateICmpEQ(body.function->getArg(1), builder.getInt32(kGliderEnter)), enter,
      resume);
  builder.SetInsertPoint(enter);
  enterState(body, index);
  builder.CreateBr(fly);
  builder.SetInsertPoint(resume);
  body.expressions.forget();
  lowerTemporals(body, lowering.index.state_temporals[index], Moment::Resume);
  builder.CreateBr(fly);
  builder.SetInsertPoint(fly);
  body.expressions.forget();
  enterActivity(body, state.profile, lowering.index.memory_blocks[index].profile);
  enterActivity(body, state.route, lowering.index.memory_blocks[index].route);
  builder.CreateRetVoid();
  return body.function;
}

}  // namespace glider::codegen
