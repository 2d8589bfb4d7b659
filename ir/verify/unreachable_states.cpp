// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/verify/passes.h"

#include <fmt/format.h>

namespace glider::ir {
namespace {

/// For every state the cases that name it, as (state, case).
using Namings = std::vector<std::vector<std::pair<uint32_t, uint32_t>>>;

Namings namings(const Mission& mission) {
  Namings result(mission.states.size());
  for (uint32_t s = 0; s < mission.states.size(); ++s) {
    for (uint32_t c = 0; c < mission.states[s].cases.size(); ++c) {
      if (const StateId target = mission.states[s].cases[c].target; target.valid()) {
        result[target.index].emplace_back(s, c);
      }
    }
  }
  return result;
}

void noteWhy(support::DiagnosticBuilder& report, const Structure& structure, uint32_t state,
             const Namings& named) {
  constexpr size_t kMost = 3;
  const Mission& m = structure.mission;
  if (named[state].empty()) {
    report.note(m.states.front().range,
                fmt::format("the mission starts in state `{}`, and no case names `{}`",
                            m.states.front().name, m.states[state].name));
  }
  for (size_t i = 0; i < named[state].size() && i < kMost; ++i) {
    const auto [from, index] = named[state][i];
    if (structure.moves[from].dead[index] != Dead::No) {
      noteDeadCase(report, structure, from, index);
    } else {
      report.note(m.states[from].cases[index].range,
                  from == state
                      ? "only its own case leads to it"
                      : fmt::format("nothing leads to state `{}` either", m.states[from].name));
    }
  }
}

}  // namespace

void passes::unreachableStates(Verification& v) {
  const Mission& m = v.structure.mission;
  const Namings named = namings(m);
  for (uint32_t s = 0; s < v.structure.size(); ++s) {
    if (!v.structure.reached(s)) {
      auto report = v.diagnostics.report(support::DiagnosticId::unreachableState, m.states[s].range,
                                         m.states[s].name);
      noteWhy(report, v.structure, s, named);
    }
  }
}

}  // namespace glider::ir
