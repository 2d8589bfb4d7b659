// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/llvm/lower/body.h"
#include "runtime/abi/glider_abi.h"

#include <algorithm>

namespace glider::codegen {

namespace {

bool isMissions(const ir::Variable& variable) {
  return variable.kind == ir::VariableKind::Mission;
}

}  // namespace

/// The mission's variables in order, then the temporals of `always`, then what runs every tick.
llvm::Function* lowerBegin(Lowering& lowering) {
  const ir::Mission& mission = lowering.mission;
  if (std::ranges::none_of(mission.variables, isMissions) &&
      lowering.index.always_temporals.empty() && !mission.every_tick.valid()) {
    return nullptr;
  }
  Body body(lowering, "begin", Body::Result::None, 0, "mission begins",
            mission.states.front().range);
  for (uint32_t i = 0; i < mission.variables.size(); ++i) {
    if (isMissions(mission.variables[i])) {
      assign(body, {i}, body.expressions.asNumber(mission.variables[i].initial));
    }
  }
  lowerWindowStarts(body, lowering.index.always_temporals);
  lowerTemporals(body, lowering.index.always_temporals, TemporalMoment::Start);
  lowerBlock(body, mission.every_tick);
  body.builder.CreateRetVoid();
  return body.function;
}

/// Returns the first `where` that is not true.
llvm::Function* lowerCondition(Lowering& lowering) {
  const std::vector<ir::ExprId>& conditions = lowering.mission.conditions;
  if (conditions.empty()) {
    return nullptr;
  }
  Body body(lowering, "condition", Body::Result::Word, 0);
  llvm::IRBuilder<>& builder = body.builder;
  for (uint32_t i = 0; i < conditions.size(); ++i) {
    llvm::BasicBlock* next = body.block("next");
    llvm::BasicBlock* violated = body.block("violated");
    builder.CreateCondBr(body.expressions.isTrue(conditions[i]), next, violated);
    builder.SetInsertPoint(violated);
    builder.CreateRet(builder.getInt32(i));
    builder.SetInsertPoint(next);
  }
  builder.CreateRet(builder.getInt32(GLIDER_NO_CASE));
  return body.function;
}

}  // namespace glider::codegen
