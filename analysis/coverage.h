// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "compiler/compilation.h"
#include "ir/prove/prove.h"

#include <optional>
#include <string>
#include <vector>

namespace glider::analysis {

/// What no proved requirement depends on alone: the mission without it is free of errors, and all
/// that is proved about the mission is proved about that one too, with a quarter of the effort.
/// What needs more counts as needed. Of two parts of which one is needed, both are named.
struct Coverage {
  size_t cases = 0;  ///< of `always` and of the states' own lists
  std::vector<ir::CasePlace> idle_cases;
  std::vector<ir::StateId> idle_states;  ///< without which: without the cases that lead to it
};

/// Of a mission of which `proved` was found; none if nothing is proved, or if it has more than 60
/// cases, each of which takes a proof of its own. `asked`: how the mission was proved.
std::optional<Coverage> coverageOf(const compiler::Checked& checked,
                                   const std::vector<ir::prove::RequirementVerdict>& proved,
                                   const ir::prove::Options& asked);

/// "any one of these could be left out, and all would still be proved: 2 of 5 cases (lines 9, 12);
/// state `track`"; empty: there are none.
std::string coverageLine(const Coverage& coverage, const compiler::Checked& checked);

}  // namespace glider::analysis
