// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/verify/passes.h"
#include "support/diagnostics/ids/verification.h"

#include <fmt/format.h>

namespace glider::ir {

void passes::emptyReturns(Verification& v) {
  for (uint32_t s = 0; s < v.structure.size(); ++s) {
    const std::optional<uint32_t> returns = v.structure.moves[s].return_case;
    if (!returns || !v.structure.meetsEmptyStack(s)) {
      continue;
    }
    const State& state = v.structure.mission.states[s];
    auto report = v.diagnostics.report(support::diagnostics::emptyReturn,
                                       state.cases[*returns].range, state.name);
    if (s == 0) {
      report.hint(fmt::format(
          "the mission starts in `{}` with an empty call stack: write `exit` to end it, or `goto`",
          state.name));
    }
    notePath(report, v.structure, v.structure.pathTo(v.structure.root(s)));
  }
}

}  // namespace glider::ir
