// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/prove.h"
#include "support/diagnostics/engine.h"
#include "support/diagnostics/ids/verification.h"

#include <limits>
#include <set>
#include <string>
#include <vector>

namespace glider::random_proofs {

/// Something that a finding says no flight does, or every flight does.
struct Claim {
  support::DiagnosticId id = support::diagnostics::unreachableState;
  std::string words;
  ir::StateId state = {};  ///< that it is about; invalid: `always`, or the mission
  ir::ListKind list = ir::ListKind::State;
  uint32_t number = 0;    ///< of a case in the list
  ir::ExprId guard = {};  ///< or another expression
  bool expected = false;  ///< of a comparison: what it always is
  /// It holds only while cases of `always` from this one on are not allowed to fire.
  uint32_t limit = std::numeric_limits<uint32_t>::max();
};

/// The claims of the diagnostics: GL3001 to GL3004, GL3012, GL3101 to GL3103, GL3109, GL3113,
/// GL3115, GL3116, GL3118, GL3121 to GL3123. `dead`: the cases that the findings rest on.
std::vector<Claim> claimsOf(const ir::Mission& mission,
                            const support::DiagnosticEngine& diagnostics,
                            const std::set<ir::CasePlace>& dead);

}  // namespace glider::random_proofs
