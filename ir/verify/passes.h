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

/// Adds a note for each step of a run from the start: `path`'s transitions, the middle of a long
/// one left out.
void notePath(support::DiagnosticBuilder& report, const Structure& structure,
              const std::vector<Edge>& path);

/// Adds a note that says why `c` of `list` never fires.
void noteDeadCase(support::DiagnosticBuilder& report, const Case& c, Dead why,
                  std::string_view list = "the state");

}  // namespace glider::ir
