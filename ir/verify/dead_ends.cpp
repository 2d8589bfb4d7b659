// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/verify/passes.h"

namespace glider::ir {

void passes::deadEnds(Verification& v) {
  for (uint32_t s = 0; s < v.structure.size(); ++s) {
    const State& state = v.structure.mission.states[s];
    if (!v.structure.reached(s) || v.structure.moves[s].leaves()) {
      continue;
    }
    auto report =
        v.diagnostics.report(support::DiagnosticId::deadEndState, state.range, state.name);
    for (uint32_t c = 0; c < state.cases.size(); ++c) {
      if (state.cases[c].transition != Transition::Stay) {
        noteDeadCase(report, v.structure, s, c);
      }
    }
  }
}

}  // namespace glider::ir
