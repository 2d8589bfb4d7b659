// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/lower/body.h"
#include "codegen/lower/guard_table.h"
#include "runtime/abi/glider_abi.h"

namespace glider::codegen {
/// What an earlier guard has worked out serves the later ones, whose blocks it dominates.
llvm::Function* lowerGuards(Lowering& lowering, const std::vector<ir::Case>& cases,
                            const ir::GuardTable& table, uint32_t memory, const std::string& name,
                            support::SourceRange range) {
  if (cases.empty()) {
    return nullptr;
  }
  if (!table.empty()) {
    return lowerGuardTable(lowering, table, cases, name, range, memory);
  }
  Body body(lowering, "guards." + name, Body::Result::Word, 1, name + " events", range);
  llvm::IRBuilder<>& builder = body.builder;
  for (uint32_t i = 0; i < cases.size(); ++i) {
    lowering.debug.locate(builder, cases[i].range);
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
