// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/campaign/depth_trust.h"

#include <algorithm>
#include <cmath>

namespace glider::simulator {
namespace {

// hookbeh's own limits.
constexpr double kReachM = 2.5, kFastestMps = 0.4, kMostAgeSecs = 16;
constexpr double kAgreeM = 5, kAgreeSecs = 60;
constexpr double kBarMetres = 10;

}  // namespace

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
    const double ctd_m = view.array.get(Sensor::sci_water_pressure) * kBarMetres;
    agrees_s_ = std::fabs(ctd_m - depth_m) <= kAgreeM ? agrees_s_ + step_s : 0;
  }
  if (agrees_s_ >= kAgreeSecs) {
    jumped_ = false;
    wrong_s_ = 0;
  }
}

}  // namespace glider::simulator
