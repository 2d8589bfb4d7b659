// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"
#include "ir/verify/structure.h"
#include "support/diagnostics/engine.h"

#include <string_view>
#include <vector>

namespace glider::ir {

/// What a check works with: it reads the structure, reports, and may add to the facts.
struct Verification {
  const Structure& structure;
  support::DiagnosticEngine& diagnostics;
  MissionFacts facts;
  bool recursive = false;  ///< a state could stand on the call stack twice
};

namespace passes {
#define PASS(name, purpose) void name(Verification& verification);
#include "ir/verify/verify_passes.def"
#undef PASS
}  // namespace passes

/// The states from which, with some call stack that they can have, no `exit` and no dead end can be
/// reached any more.
std::vector<bool> statesWithoutEnd(const Structure& structure);

/// The reached states in an order in which callers come before those that they call themselves;
/// where such calls make a cycle, what is in it or called from it is left out.
std::vector<uint32_t> callersFirst(const Structure& structure);

/// Whether a case of `always` may come between so that a state is on the stack twice; the states'
/// own calls make no cycle. Linear.
bool interruptionsRecur(const Structure& structure);
/// Reports each call that this makes a mistake. Takes a while for each case of `always`.
void reportInterruptions(Verification& verification);

/// Adds a note for each step of a run from the start: `path`'s transitions, the middle of a long
/// one left out.
void notePath(support::DiagnosticBuilder& report, const Structure& structure, const Path& path);

/// Adds a note that says why `c` of `list` never fires.
void noteDeadCase(support::DiagnosticBuilder& report, const Case& c, Dead why,
                  std::string_view list = "the state");

}  // namespace glider::ir
