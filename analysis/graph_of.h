// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "compiler/proving.h"
#include "report/graph/graph.h"

namespace glider::analysis {

/// The state machine of a mission, with its texts as the pilot wrote them. `deepest_path` is that
/// of ir::MissionFacts; `dead` are the cases proved never to fire, from casesThatNeverFire(). Both
/// may be empty for a mission with errors.
report::Graph graphOf(const compiler::Lowered& mission,
                      const std::vector<ir::StateId>& deepest_path,
                      const std::map<ir::CasePlace, bool>& dead);

}  // namespace glider::analysis
