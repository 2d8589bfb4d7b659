// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/verify/passes.h"
#include "support/diagnostics/ids/verification.h"

namespace glider::ir {
namespace {

/// A `goto` empties the stack, and what the state calls returns to it: so a state that was called
/// returns to its caller only by a case of its own with `return`.
void reportCalls(Verification& v, const std::vector<Edge>& edges) {
  for (const Edge& edge : edges) {
    const State& target = v.structure.mission.states[edge.to];
    const bool itself = &edges != &v.structure.always.edges && edge.to == edge.from;  // an error
    const bool for_good = edge.call && !itself && !v.structure.moves[edge.to].return_case;
    if (!for_good || !v.structure.reached(edge.to) || v.structure.deadEnd(edge.to)) {
      continue;
    }
    auto report = v.diagnostics.report(support::diagnostics::callForGood,
                                       v.structure.caseOf(edge).range, target.name);
    for (uint32_t c = 0; c < target.cases.size(); ++c) {
      if (target.cases[c].transition == Transition::Return) {
        noteDeadCase(report, target.cases[c], v.structure.moves[edge.to].dead[c]);
      }
    }
  }
}

}  // namespace

void passes::callsForGood(Verification& v) {
  for (uint32_t s = 0; s < v.structure.size(); ++s) {
    if (v.structure.reached(s)) {
      reportCalls(v, v.structure.moves[s].edges);
    }
  }
  reportCalls(v, v.structure.always.edges);
}

}  // namespace glider::ir
