// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/seat/cycle_times.h"

#include <algorithm>
#include <cmath>

namespace glider::simulator {

constexpr double kShortestS = 1;

int64_t CycleTimes::steps() {
  const double mean = settings_.mean_s > 0 ? settings_.mean_s : nominal_s_;
  const double usual = std::max(mean + noise_.normal(settings_.spread_s), kShortestS);
  const bool is_long = noise_.uniform() < settings_.long_share;
  return std::lround((is_long ? settings_.long_s : usual) / step_s_);
}

}  // namespace glider::simulator
