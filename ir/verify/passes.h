// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"
#include "ir/verify/structure.h"
#include "support/diagnostics/engine.h"

#include <string_view>
#include <vector>

namespace glider::ir {

/// The data of a check: it reads the structure, reports, and may add to the facts.
struct Verification {
  const Structure& structure;
  support::DiagnosticEngine& diagnostics;
  MissionFacts facts;
  bool recursive = false;  ///< a state could be on the call stack twice
};

namespace passes {
#define PASS(name, purpose) void name(Verification& verification);
#include "ir/verify/verify_passes.def"
#undef PASS
}  // namespace passes

/// The states from which, with some call stack that they can have, neither an `exit` nor a dead end
/// can be reached any more.
std::vector<bool> statesWithoutEnd(const Structure& structure);

/// The reached states in an order in which callers come before the states that they call
/// themselves; if such calls form a cycle, its states and those called from it are left out.
std::vector<uint32_t> callersFirst(const Structure& structure);

/// Whether a case of `always` may interrupt so that a state is on the stack twice; the states' own
/// calls must not form a cycle. Linear.
bool interruptionsRecur(const Structure& structure);
/// Reports each call that is an error for this reason. The time grows with the number of cases of
/// `always`.
void reportInterruptions(Verification& verification);

/// Adds a note for each step of a trace from the start: the transitions of `path`; the middle of a
/// long one is left out.
void notePath(support::DiagnosticBuilder& report, const Structure& structure, const Path& path);

/// Adds a note that says why `c` of `list` never fires.
void noteDeadCase(support::DiagnosticBuilder& report, const Case& c, Dead why,
                  std::string_view list = "the state");

}  // namespace glider::ir
