// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/verify/passes.h"
#include "support/diagnostics/ids/verification.h"

namespace glider::ir {

void passes::deadEnds(Verification& v) {
  for (uint32_t s = 0; s < v.structure.size(); ++s) {
    const State& state = v.structure.mission.states[s];
    if (!v.structure.reached(s) || !v.structure.deadEnd(s)) {
      continue;
    }
    auto report = v.diagnostics.report(support::diagnostics::deadEndState, state.range, state.name);
    for (uint32_t c = 0; c < state.cases.size(); ++c) {
      if (state.cases[c].transition != Transition::Stay) {
        noteDeadCase(report, state.cases[c], v.structure.moves[s].dead[c]);
      }
    }
    if (v.structure.lowestLimit(s) != kEndlessLimit) {
      report.note(v.structure.mission.always[v.structure.lowestLimit(s)].range,
                  "entered through this case; only earlier cases of `always` can interrupt it");
    }
  }
}

}  // namespace glider::ir
