// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/lower/expressions.h"
#include "codegen/lower/lowering.h"

namespace glider::codegen {
namespace {

llvm::Function* lowerStateLog(Lowering& lowering, const ir::State& state) {
  llvm::LLVMContext& context = lowering.module.getContext();
  llvm::IRBuilder<> builder(context);
  llvm::Function* function = makeFunction(
      lowering,
      llvm::FunctionType::get(builder.getDoubleTy(), {builder.getPtrTy(), builder.getInt32Ty()},
                              false),
      "log." + state.name);
  auto* none = llvm::BasicBlock::Create(context, "none", function);
  builder.SetInsertPoint(&function->getEntryBlock());
  llvm::SwitchInst* choice =
      builder.CreateSwitch(function->getArg(1), none, static_cast<unsigned>(state.log.size()));
  builder.SetInsertPoint(none);
  builder.CreateRet(llvm::ConstantFP::getNaN(builder.getDoubleTy()));
  for (uint32_t i = 0; i < state.log.size(); ++i) {
    auto* item = llvm::BasicBlock::Create(context, "item", function);
    choice->addCase(builder.getInt32(i), item);
    builder.SetInsertPoint(item);
    Expressions expressions(lowering, builder, function->getArg(0));
    builder.CreateRet(expressions.number(state.log[i].value));
  }
  return function;
}

}  // namespace

llvm::Function* lowerLogValue(Lowering& lowering) {
  // One function serves all states that log nothing.
  std::vector<llvm::Function*> by_state;
  llvm::Function* nothing = nullptr;
  for (const ir::State& state : lowering.mission.states) {
    if (state.log.empty()) {
      nothing = nothing != nullptr ? nothing : lowerStateLog(lowering, state);
    }
    by_state.push_back(state.log.empty() ? nothing : lowerStateLog(lowering, state));
  }
  return makeDispatcher(lowering, "log_value", by_state);
}

}  // namespace glider::codegen
