// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/lower/expressions.h"
#include "codegen/lower/lowering.h"
#include "runtime/abi/glider_abi.h"

namespace glider::codegen {
namespace {

/// The cases in order. What an earlier guard has worked out serves the later ones, whose blocks it
/// dominates.
llvm::Function* lowerStateGuards(Lowering& lowering, const ir::State& state) {
  llvm::LLVMContext& context = lowering.module.getContext();
  llvm::IRBuilder<> builder(context);
  llvm::Function* function = makeFunction(
      lowering, llvm::FunctionType::get(builder.getInt32Ty(), {builder.getPtrTy()}, false),
      "guards." + state.name);
  lowering.debug.describe(*function, state.name + " events", state.range);
  builder.SetInsertPoint(&function->getEntryBlock());
  lowering.debug.locate(builder, state.range);
  Expressions expressions(lowering, builder, function->getArg(0));
  for (uint32_t i = 0; i < state.cases.size(); ++i) {
    lowering.debug.locate(builder, state.cases[i].range);
    auto* fires = llvm::BasicBlock::Create(context, "fires", function);
    auto* next = llvm::BasicBlock::Create(context, "next", function);
    builder.CreateCondBr(expressions.isTrue(state.cases[i].guard), fires, next);
    builder.SetInsertPoint(fires);
    lowering.debug.locate(builder, state.cases[i].range);
    builder.CreateRet(builder.getInt32(i));
    builder.SetInsertPoint(next);
  }
  builder.CreateRet(builder.getInt32(GLIDER_NO_CASE));
  return function;
}

}  // namespace

llvm::Function* lowerGuards(Lowering& lowering) {
  std::vector<llvm::Function*> by_state;
  for (const ir::State& state : lowering.mission.states) {
    by_state.push_back(lowerStateGuards(lowering, state));
  }
  return makeDispatcher(lowering, "guards", by_state);
}

}  // namespace glider::codegen
