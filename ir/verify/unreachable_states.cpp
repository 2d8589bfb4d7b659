// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/verify/passes.h"
#include "support/diagnostics/ids/verification.h"

#include <fmt/format.h>

#include <optional>

namespace glider::ir {
namespace {

/// A case that names a state; if its own state is invalid, a case of `always`.
struct Naming {
  std::optional<uint32_t> from;
  const Case* by = nullptr;
  Dead dead = Dead::No;
};

/// For every state the cases that name it.
using Namings = std::vector<std::vector<Naming>>;

void addNamings(Namings& result, const std::vector<Case>& cases, const Moves& moves,
                std::optional<uint32_t> from) {
  for (size_t i = 0; i < cases.size(); ++i) {
    if (cases[i].target.valid()) {
      result[cases[i].target.index].push_back({from, &cases[i], moves.dead[i]});
    }
  }
}

Namings namings(const Structure& structure) {
  Namings result(structure.size());
  addNamings(result, structure.mission.always, structure.always, std::nullopt);
  for (uint32_t s = 0; s < structure.size(); ++s) {
    addNamings(result, structure.mission.states[s].cases, structure.moves[s], s);
  }
  return result;
}

void noteWhy(support::DiagnosticBuilder& report, const Structure& structure, uint32_t state,
             const Namings& named) {
  constexpr size_t kMost = 3;
  const Mission& m = structure.mission;
  if (named[state].empty()) {
    report.note(m.states.front().range,
                fmt::format("the mission starts in state `{}`, and no case leads to `{}`",
                            m.states.front().name, m.states[state].name));
  }
  for (size_t i = 0; i < named[state].size() && i < kMost; ++i) {
    const Naming& naming = named[state][i];
    if (naming.dead != Dead::No || !naming.from) {
      noteDeadCase(report, *naming.by, naming.dead, naming.from ? "the state" : "`always`");
    } else {
      report.note(naming.by->range,
                  *naming.from == state
                      ? "only its own case leads to it"
                      : fmt::format("state `{}` is unreachable too", m.states[*naming.from].name));
    }
  }
}

}  // namespace

void passes::unreachableStates(Verification& v) {
  const Mission& m = v.structure.mission;
  const Namings named = namings(v.structure);
  for (uint32_t s = 0; s < v.structure.size(); ++s) {
    if (!v.structure.reached(s)) {
      auto report = v.diagnostics.report(support::diagnostics::unreachableState, m.states[s].range,
                                         m.states[s].name);
      noteWhy(report, v.structure, s, named);
    }
  }
}

}  // namespace glider::ir
