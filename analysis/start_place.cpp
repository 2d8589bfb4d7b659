// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "analysis/start_place.h"

#include "ir/core/inside.h"
#include "support/diagnostics/ids/verification.h"
#include "support/units/position_text.h"

#include <fmt/format.h>

#include <algorithm>

namespace glider::analysis {

void checkStart(const compiler::Checked& mission, const StartPlace& start,
                support::DiagnosticEngine& diagnostics) {
  const auto& all = mission.mission().assumptions;
  const auto assumed =
      std::ranges::find(all, ir::AssumptionKind::StartInside, &ir::Assumption::kind);
  if (assumed != all.end() &&
      !ir::isInside(assumed->area, {start.at.latitude, start.at.longitude})) {
    diagnostics.report(support::diagnostics::startUnassumed, assumed->range, start.name,
                       "at " + support::positionText(start.at.latitude, start.at.longitude),
                       "`" + assumed->words + "`");
  }
}

}  // namespace glider::analysis
