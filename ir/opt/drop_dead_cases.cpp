// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/opt/compact.h"
#include "ir/opt/passes.h"

#include <algorithm>

namespace glider::ir::opt {
namespace {

/// A case that never fires keeps only its number, which the log names. Cases after one that always
/// fires are removed. In `always` a case may be passed over even if its guard holds.
void prune(const Mission& mission, std::vector<Case>& cases, bool may_be_passed_over) {
  for (Case& c : cases) {
    if (mission[c.guard].op == Op::False) {
      c.action = {};
      c.arguments.clear();
      c.transition = Transition::Stay;
      c.target = {};
    }
  }
  const auto always =
      std::ranges::find_if(cases, [&](const Case& c) { return mission[c.guard].op == Op::True; });
  if (always != cases.end() && !may_be_passed_over) {
    cases.erase(always + 1, cases.end());
  }
  while (!cases.empty() && mission[cases.back().guard].op == Op::False) {
    cases.pop_back();
  }
}

/// Replaces `if true` and `if false` by their statements.
void straighten(Mission& mission, Block& block) {
  std::vector<Statement> straight;
  for (Statement& statement : block.statements) {
    const Op op = statement.kind == StatementKind::If ? mission[statement.value].op : Op::Constant;
    if (op != Op::True && op != Op::False) {
      straight.push_back(std::move(statement));
      continue;
    }
    const BlockId taken = op == Op::True ? statement.then : statement.otherwise;
    if (taken.valid()) {  // it precedes this block, so it has already been straightened
      const auto& inner = mission[taken].statements;
      straight.insert(straight.end(), inner.begin(), inner.end());
    }
  }
  block.statements = std::move(straight);
}

}  // namespace

void dropDeadCases(Mission& mission) {
  prune(mission, mission.always, true);
  for (State& state : mission.states) {
    prune(mission, state.cases, false);
    prune(mission, state.profile.cases, false);
    prune(mission, state.route.cases, false);
  }
  for (Block& block : mission.blocks) {
    straighten(mission, block);
  }
  compact(mission);
}

}  // namespace glider::ir::opt
