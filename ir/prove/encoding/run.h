// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/context/control.h"

#include <optional>
#include <vector>

namespace glider::ir::prove {

/// A step of a run that was found: what the tick saw.
struct Step {
  double mission_time = 0;
  Control after;                 ///< where it led; of the last one, perhaps as before
  std::vector<double> readings;  ///< by sensor, SI units; NaN: unknown
  std::optional<double> depth;   ///< true depth (m), if the question reckons with it
};

/// A run in steps of any length, between which nothing fires.
struct Run {
  std::vector<double> parameters;  ///< by their number
  std::vector<Step> steps;         ///< the first at the start
};

}  // namespace glider::ir::prove
