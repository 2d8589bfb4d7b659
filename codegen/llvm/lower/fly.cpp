// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/llvm/lower/body.h"
#include "runtime/abi/glider_abi.h"

namespace glider::codegen {
namespace {

/// The first case whose guard is true fires: its block runs, and `done` sets its truth value.
void lowerCases(Body& body, const ir::Activity& activity) {
  llvm::IRBuilder<>& builder = body.builder;
  for (uint32_t i = 0; i < activity.cases.size(); ++i) {
    const ir::Case& item = activity.cases[i];
    body.lowering.debug.locate(builder, item.range);
    llvm::BasicBlock* fires = body.block("fires");
    llvm::BasicBlock* next = body.block("next");
    builder.CreateCondBr(body.expressions.isTrue(item.guard), fires, next);
    const Expressions::Mark mark = body.expressions.mark();
    builder.SetInsertPoint(fires);
    lowerBlock(body, item.action);
    if (item.transition == ir::Transition::Done) {
      assign(body, activity.done, llvm::ConstantFP::get(builder.getDoubleTy(), 1.0));
    }
    builder.CreateRet(builder.getInt32(i));
    builder.SetInsertPoint(next);
    body.expressions.rollBack(mark);
  }
}

/// In a tick.
bool doesNothing(const Lowering& lowering, const ir::Activity& activity) {
  return lowering.mission[activity.behaviour].symbol.empty() && activity.cases.empty();
}

}  // namespace

void callBehaviour(Body& body, const ir::Activity& activity, uint32_t memory_block,
                   llvm::Value* phase) {
  llvm::IRBuilder<>& builder = body.builder;
  body.lowering.debug.locate(builder, activity.range);
  llvm::Value* memory = body.contextField(field::GliderContext::memory);
  auto* block_type = llvm::ArrayType::get(builder.getInt8Ty(), GLIDER_BEHAVIOUR_MEMORY_BYTES);
  std::vector<llvm::Value*> arguments{
      body.context(), builder.CreateConstInBoundsGEP1_32(block_type, memory, memory_block), phase};
  for (const ir::ExprId argument : activity.arguments) {
    arguments.push_back(body.expressions.asNumber(argument));
  }
  body.lowering.debug.locate(builder, activity.range);
  body.call(body.lowering.mission[activity.behaviour].symbol, arguments);
}

llvm::Function* lowerFly(Lowering& lowering, uint32_t state, const ir::Activity& activity,
                         const std::string& kind, uint32_t memory_block) {
  if (doesNothing(lowering, activity)) {
    return nullptr;
  }
  const std::string& name = lowering.mission.states[state].name;
  Body body(lowering, kind + "." + name, Body::Result::Word, 0, name + " " + kind, activity.range);
  if (lowering.mission[activity.behaviour].symbol.empty()) {
    lowerCases(body, activity);
  } else {
    callBehaviour(body, activity, memory_block, body.builder.getInt32(kGliderTick));
  }
  body.builder.CreateRet(body.builder.getInt32(GLIDER_NO_CASE));
  return body.function;
}

llvm::Function* declareFly(Lowering& lowering, uint32_t state, const ir::Activity& activity,
                           const std::string& kind) {
  const std::string& name = lowering.mission.states[state].name;
  return doesNothing(lowering, activity)
             ? nullptr
             : declareFunction(lowering, kind + "." + name, Body::Result::Word, 0);
}

}  // namespace glider::codegen
