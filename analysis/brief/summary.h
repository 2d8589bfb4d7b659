// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "compiler/compilation.h"
#include "report/findings/findings.h"
#include "vehicles/own_mission.h"

#include <string>
#include <vector>

namespace glider::analysis {

/// What the crew should know first, in sentences: the verdicts, the end, the depth, the call stack,
/// the way home by `own` (null: it is not known), power cuts. `deepest_m` is the deepest that
/// commands lead to.
std::vector<std::string> summaryOf(const compiler::Checked& checked,
                                   const report::CheckedMission& found,
                                   const vehicles::OwnMission* own, double deepest_m);

/// What the proofs and bounds assume about the vehicle and the water, and what the mission assumes.
std::string assumptionsOf(const platforms::Platform& platform, const ir::Mission& mission);

}  // namespace glider::analysis
