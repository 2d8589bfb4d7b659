// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/lower/expressions.h"
#include "codegen/lower/lowering.h"
#include "runtime/abi/glider_abi.h"

namespace glider::codegen {
namespace {

/// In the memory of GliderContext, two blocks a state: its profile's, then its route's.
constexpr uint32_t kBlocksAState = 2;

std::vector<llvm::Value*> evaluate(Expressions& expressions, const ir::Activity& activity) {
  std::vector<llvm::Value*> values;
  for (const ir::ExprId argument : activity.arguments) {
    values.push_back(expressions.number(argument));
  }
  return values;
}

/// Calls the behaviour's C function (runtime/abi/behaviour.h) with its block of memory.
void callBehaviour(Lowering& lowering, llvm::IRBuilder<>& builder, const ir::Activity& activity,
                   const std::vector<llvm::Value*>& values, uint32_t block) {
  llvm::Function* function = builder.GetInsertBlock()->getParent();
  lowering.debug.locate(builder, activity.range);
  llvm::Value* memory = loadField(builder, lowering.types.GliderContext, function->getArg(0),
                                  field::GliderContext::memory);
  auto* block_type = llvm::ArrayType::get(builder.getInt8Ty(), GLIDER_BEHAVIOUR_MEMORY_BYTES);
  std::vector<llvm::Value*> arguments{function->getArg(0),
                                      builder.CreateConstInBoundsGEP1_32(block_type, memory, block),
                                      function->getArg(1)};
  std::vector<llvm::Type*> types{builder.getPtrTy(), builder.getPtrTy(), builder.getInt32Ty()};
  arguments.insert(arguments.end(), values.begin(), values.end());
  types.resize(arguments.size(), builder.getDoubleTy());
  builder
      .CreateCall(lowering.module.getOrInsertFunction(
                      lowering.mission[activity.behaviour].symbol,
                      llvm::FunctionType::get(builder.getVoidTy(), types, false)),
                  arguments)
      ->setDoesNotThrow();
}

/// All arguments first, so that the route's are those of the same moment as the profile's.
llvm::Function* lowerStateFly(Lowering& lowering, uint32_t index) {
  const ir::State& state = lowering.mission.states[index];
  llvm::IRBuilder<> builder(lowering.module.getContext());
  llvm::Function* function =
      makeFunction(lowering,
                   llvm::FunctionType::get(builder.getVoidTy(),
                                           {builder.getPtrTy(), builder.getInt32Ty()}, false),
                   "fly." + state.name);
  lowering.debug.describe(*function, state.name + " flies", state.range);
  builder.SetInsertPoint(&function->getEntryBlock());
  lowering.debug.locate(builder, state.range);
  Expressions expressions(lowering, builder, function->getArg(0));
  const std::vector<llvm::Value*> profile = evaluate(expressions, state.profile);
  const std::vector<llvm::Value*> route = evaluate(expressions, state.route);
  callBehaviour(lowering, builder, state.profile, profile, kBlocksAState * index);
  callBehaviour(lowering, builder, state.route, route, kBlocksAState * index + 1);
  builder.CreateRetVoid();
  return function;
}

}  // namespace

llvm::Function* lowerFly(Lowering& lowering) {
  std::vector<llvm::Function*> by_state;
  for (uint32_t i = 0; i < lowering.mission.states.size(); ++i) {
    by_state.push_back(lowerStateFly(lowering, i));
  }
  return makeDispatcher(lowering, "fly", by_state);
}

}  // namespace glider::codegen
