// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/llvm/lower/body.h"
#include "codegen/llvm/lower/guard_table.h"
#include "runtime/abi/glider_abi.h"

namespace glider::codegen {
namespace {

/// Case i is skipped if its number does not allow it to fire: functions in its guard are not
/// called.
void stopAtLimit(Body& body, uint32_t i) {
  llvm::IRBuilder<>& builder = body.builder;
  llvm::BasicBlock* stop = body.block("stop");
  llvm::BasicBlock* go_on = body.block("go_on");
  llvm::Value* limit = body.contextField(field::GliderContext::limit);
  builder.CreateCondBr(builder.CreateICmpULE(limit, builder.getInt32(i)), stop, go_on);
  builder.SetInsertPoint(stop);
  builder.CreateRet(builder.getInt32(GLIDER_NO_CASE));
  builder.SetInsertPoint(go_on);
}

}  // namespace

/// Values that an earlier guard has computed are reused by the later ones, whose blocks it
/// dominates.
llvm::Function* lowerGuards(Lowering& lowering, const std::vector<ir::Case>& cases,
                            const ir::GuardTable& table, uint32_t memory, const std::string& name,
                            support::SourceRange range) {
  if (cases.empty()) {
    return nullptr;
  }
  if (!table.empty()) {
    return lowerGuardTable(lowering, table, cases, name, range, memory);
  }
  const bool limited = !lowering.mission.uses.empty() && &cases == &lowering.mission.always;
  Body body(lowering, "guards." + name, Body::Result::Word, 1, name + " events", range);
  llvm::IRBuilder<>& builder = body.builder;
  for (uint32_t i = 0; i < cases.size(); ++i) {
    lowering.debug.locate(builder, cases[i].range);
    if (limited) {
      stopAtLimit(body, i);
    }
    llvm::Value* tried = builder.CreateICmpULE(body.function->getArg(1), builder.getInt32(i));
    llvm::Value* is_true = body.expressions.isTrue(cases[i].guard);
    llvm::BasicBlock* fires = body.block("fires");
    llvm::BasicBlock* next = body.block("next");
    builder.CreateCondBr(builder.CreateAnd(tried, is_true), fires, next);
    builder.SetInsertPoint(fires);
    lowering.debug.locate(builder, cases[i].range);
    builder.CreateRet(builder.getInt32(i));
    builder.SetInsertPoint(next);
  }
  builder.CreateRet(builder.getInt32(GLIDER_NO_CASE));
  return body.function;
}

}  // namespace glider::codegen
