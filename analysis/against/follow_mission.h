// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "analysis/against/log_ticks.h"
#include "compiler/compilation.h"
#include "report/findings/against.h"

#include <cstdint>
#include <span>
#include <vector>

namespace glider::analysis {

/// The mission as it follows the log.
struct Followed {
  std::vector<report::FollowedStep> steps;
  std::vector<uint32_t>
      states;  ///< the current state at each tick; kNoState: the mission does not run
  static constexpr uint32_t kNoState = UINT32_MAX;
  std::vector<uint32_t> true_ticks;  ///< of each of watchedCases(), while its state is current
};

/// Starts the mission at the first tick below the surface, takes every transition that fires, and
/// starts it again at the first dive from the surface after it has ended, and at the first tick
/// below the surface after a gap that is longer than the mission's `resume within`. A case that
/// stays is a step once while its guard remains true.
Followed followMission(const compiler::Checked& checked, const LogTicks& log,
                       std::span<const double> parameters);

}  // namespace glider::analysis
