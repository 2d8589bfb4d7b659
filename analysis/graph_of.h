// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "compiler/proving.h"
#include "report/graph/graph.h"

namespace glider::analysis {

/// The state machine of a mission, with its texts as the pilot wrote them. `deepest_path` as of
/// ir::MissionFacts; `dead`: what is proved never to fire, as casesThatNeverFire() says. Of a
/// mission with errors both may be empty.
report::Graph graphOf(const compiler::Lowered& mission,
                      const std::vector<ir::StateId>& deepest_path,
                      const std::map<ir::CasePlace, bool>& dead);

}  // namespace glider::analysis
