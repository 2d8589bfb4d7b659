// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "analysis/check/check.h"
#include "report/plan/plan.h"
#include "support/result.h"

#include <cstddef>
#include <string>

namespace glider::analysis {

/// What was planned, and how the mission's text says it.
struct PlannedMission {
  report::Plan plan;
  /// The text of the mission with what was chosen in its lines `choose`; empty: nothing was.
  std::string text;
};

/// Whether a mission can be planned: its text has no error but by the values of its lines `choose`,
/// and none in those lines.
bool isPlannable(const compiler::Compilation& compiled);

/// The most ways to choose that are tried.
inline constexpr size_t kMostPlans = 10000;

/// Chooses what a plannable mission leaves open; what is written in its lines `choose` does not
/// matter: of all ways for which `check` proves every requirement,
/// the one that its line `prefer` puts first; what is left goes by the energy. The ways are those
/// of PlanGrid. Each that is chosen or on the front has been checked as if its values were written,
/// with `options`. `observer` receives what is done. Fails if the mission leaves nothing open or
/// too much, if it prefers what is not known of its vehicle, and as a check does.
support::Result<PlannedMission> planMission(const std::string& name,
                                            const compiler::Compilation& compiled,
                                            const CheckOptions& options, CheckObserver& observer);

}  // namespace glider::analysis
