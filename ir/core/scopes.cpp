// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/core/scopes.h"

#include "ir/core/ops.h"

#include <algorithm>

namespace glider::ir {
namespace {

void readState(Reads& reads, StateId state) {
  if (state.valid()) {
    reads.two_states |= reads.state.valid() && reads.state != state;
    reads.state = state;
  }
}

void join(Reads& reads, const Reads& operand) {
  readState(reads, operand.state);
  reads.two_states |= operand.two_states;
  reads.variables_end = std::max(reads.variables_end, operand.variables_end);
  reads.temporals_end = std::max(reads.temporals_end, operand.temporals_end);
  reads.moment |= operand.moment;
  reads.mission |= operand.mission;
  reads.monitor |= operand.monitor;
}

}  // namespace

Reads readsOf(const Mission& mission, const Expr& e, const std::vector<Reads>& operands) {
  Reads reads;
  for (uint32_t k = 0; k < operandCount(e); ++k) {
    join(reads, operands[e.operands.at(k).index]);
  }
  if (e.op == Op::Variable) {
    const Variable& v = mission[e.variable];
    readState(reads, v.owner);
    reads.variables_end = e.variable.index + 1;
    reads.mission = v.kind == VariableKind::Mission;
    reads.monitor = isOfMonitor(v.kind);
  } else if (e.op == Op::Temporal) {
    readState(reads, mission[e.temporal].state);
    reads.temporals_end = e.temporal.index + 1;
  } else {
    reads.moment |= e.sensor.valid() || groupOf(e.op) == OpGroup::Clock || e.op == Op::Call;
  }
  return reads;
}

std::vector<Reads> readsOf(const Mission& mission) {
  std::vector<Reads> all;
  for (const Expr& e : mission.exprs) {
    all.push_back(readsOf(mission, e, all));
  }
  return all;
}

}  // namespace glider::ir
