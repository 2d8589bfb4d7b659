// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/hookbeh/recent_depths.h"

#include "hooks/protocol/numbers.h"

namespace glider::hooks {
namespace {

constexpr double kKeptSecs = 20;

}  // namespace

void RecentDepths::observe(double depth_m, double step_s) {
  for (Sample& sample : samples_) {
    sample.age_s += step_s;
  }
  samples_[next_] = {depth_m};
  next_ = static_cast<uint8_t>((next_ + 1) % kCount);
}

double RecentDepths::distanceTo(double depth_m) const {
  double highest = __builtin_nan("");
  double lowest = __builtin_nan("");
  for (const Sample& sample : samples_) {
    if (!isFinite(sample.depth_m) || sample.age_s > kKeptSecs) {
      continue;
    }
    highest = atMost(highest, sample.depth_m);  // or the first
    lowest = atLeast(lowest, sample.depth_m);
  }
  return atLeast(0, atLeast(highest - depth_m, depth_m - lowest));
}

}  // namespace glider::hooks
