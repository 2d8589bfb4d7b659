// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/llvm/lower/body.h"
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

/// Generates `only` for the phase enter, then continues.
void onEnter(Body& body, llvm::function_ref<void()> only) {
  llvm::IRBuilder<>& builder = body.builder;
  llvm::BasicBlock* enter = body.block("enter");
  llvm::BasicBlock* either = body.block("either");
  builder.CreateCondBr(
      builder.CreateICmpEQ(body.function->getArg(1), builder.getInt32(kGliderEnter)), enter,
      either);
  builder.SetInsertPoint(enter);
  body.expressions.forget();
  only();
  builder.CreateBr(either);
  builder.SetInsertPoint(either);
  body.expressions.forget();
}

/// The state's, its profile's and its route's variables get their initial values.
void startVariables(Body& body, const std::vector<ir::VariableId>& variables) {
  for (const ir::VariableId variable : variables) {
    assign(body, variable, body.expressions.asNumber(body.lowering.mission[variable].initial));
  }
}

bool comesWithNothing(const Lowering& lowering, const ir::Activity& activity) {
  return lowering.mission[activity.behaviour].symbol.empty() && !activity.entry.valid();
}

bool hasNothingToDo(const Lowering& lowering, uint32_t index) {
  const ir::State& state = lowering.mission.states[index];
  return !lowering.index.samples && lowering.index.state_variables[index].empty() &&
         lowering.index.state_temporals[index].empty() && !state.entry.valid() &&
         comesWithNothing(lowering, state.profile) && comesWithNothing(lowering, state.route);
}

}  // namespace

// Entering and resuming differ in what starts again and in the state's own entry.
llvm::Function* lowerEnter(Lowering& lowering, uint32_t index) {
  if (hasNothingToDo(lowering, index)) {
    return nullptr;
  }
  const ir::State& state = lowering.mission.states[index];
  const auto& variables = lowering.index.state_variables[index];
  const auto& temporals = lowering.index.state_temporals[index];
  Body body(lowering, "enter." + state.name, Body::Result::None, 1, state.name + " begins",
            state.range);
  if (!variables.empty() || !temporals.empty()) {
    onEnter(body, [&] {
      startVariables(body, variables);
      lowerWindowStarts(body, temporals);
    });
  }
  lowerTemporals(body, temporals, TemporalMoment::Start);
  if (lowering.index.samples) {
    lowerSampling(body, state);
  }
  if (state.entry.valid()) {
    onEnter(body, [&] { lowerBlock(body, state.entry); });
  }
  enterActivity(body, state.profile, lowering.index.memory_blocks[index].profile);
  enterActivity(body, state.route, lowering.index.memory_blocks[index].route);
  body.builder.CreateRetVoid();
  return body.function;
}

}  // namespace glider::codegen
