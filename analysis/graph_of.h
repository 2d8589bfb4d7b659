// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "compiler/compilation.h"
#include "report/graph/graph.h"

namespace glider::analysis {

/// The state machine of a compilation's mission, with its texts as the pilot wrote them. `dead`:
/// what is proved never to fire, as casesThatNeverFire() says.
report::Graph graphOf(const compiler::Compilation& compilation,
                      const std::map<ir::CasePlace, bool>& dead);

}  // namespace glider::analysis
