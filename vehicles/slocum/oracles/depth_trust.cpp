// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/oracles/depth_trust.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace glider::slocum::oracles {
namespace {

// hookbeh's own limits.
constexpr double kReachM = 2.5, kFastestMps = 0.4, kMostAgeSecs = 16;
constexpr double kAgreeM = 5, kAgreeSecs = 60;
constexpr double kMetresPerBar = 10;

}  // namespace

double ctdDepth(const CycleView& view) {
  return view.array.fresh(Sensor::sci_water_pressure)
             ? view.array.get(Sensor::sci_water_pressure) * kMetresPerBar
             : std::numeric_limits<double>::quiet_NaN();
}

void DepthTrust::cycle(const CycleView& view, double step_s) {
  const double depth_m = view.array.get(Sensor::m_depth);
  age_s_ += step_s;
  if (depth_m != last_m_) {
    jumped_ = jumped_ ||
              std::fabs(depth_m - last_m_) > kReachM + kFastestMps * std::min(age_s_, kMostAgeSecs);
    last_m_ = depth_m;
    age_s_ = 0;
  }
  wrong_s_ += std::fabs(depth_m - view.true_depth_m) > kReachM ? step_s : 0;
  if (view.array.fresh(Sensor::sci_water_pressure)) {
    agrees_s_ = std::fabs(ctdDepth(view) - depth_m) <= kAgreeM ? agrees_s_ + step_s : 0;
  }
  if (agrees_s_ >= kAgreeSecs) {
    jumped_ = false;
    wrong_s_ = 0;
  }
}

}  // namespace glider::slocum::oracles
