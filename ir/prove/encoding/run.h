// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/context/control.h"

#include <optional>
#include <vector>

namespace glider::ir::prove {

/// A step of a trace from the solver: the readings of its tick.
struct Step {
  double mission_time = 0;
  Control after;                 ///< the control after it; after the last step, possibly unchanged
  std::vector<double> readings;  ///< by sensor, SI units; NaN: unknown
  std::optional<double> depth;   ///< true depth (m), if the question takes it into account
};

/// A trace in steps of any length, between which nothing fires.
struct Run {
  std::vector<double> parameters;  ///< by their number
  std::vector<Step> steps;         ///< the first at the start
};

}  // namespace glider::ir::prove
