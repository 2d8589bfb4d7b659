// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/hookbeh/hover.h"

#include "hooks/protocol/numbers.h"

namespace glider::hooks {
namespace {

// A glider of about 100 kg (with the water it moves) and 0.0098 N a cc swings with a period of 100
// s about its depth at this gain; the damping is near critical.
constexpr double kPumpPerMetre = 40.0;
constexpr double kPumpPerMetreASecond = 1000.0;
/// s; over this time a depth is smoothed: the swings of swell and the noise of a sensor are faster,
/// those of the vehicle are slower.
constexpr double kSmoothSecs = 6;
/// cc; the pump rests while its new volume would differ by less.
constexpr double kRestsCc = 25;

}  // namespace

/// A g-h filter with two equal time constants (a fading memory): an extrapolation of the last
/// estimate is corrected by the reading.
void Hover::follow(const Surroundings& now, double step_s) {
  age_s_ += step_s;
  if (!isFinite(now.depth_m) || now.depth_m == read_m_) {
    return;  // the sensor array keeps a reading until there is a newer one
  }
  if (!isFinite(depth_m_)) {
    depth_m_ = now.depth_m;
    rate_mps_ = isFinite(now.depth_rate_mps) ? now.depth_rate_mps : 0;
  } else if (age_s_ > 0) {
    const double keeps = kSmoothSecs / (kSmoothSecs + age_s_);
    const double off = now.depth_m - (depth_m_ + rate_mps_ * age_s_);
    depth_m_ += rate_mps_ * age_s_ + (1 - keeps * keeps) * off;
    rate_mps_ += (1 - keeps) * (1 - keeps) * off / age_s_;
  }
  read_m_ = now.depth_m;
  age_s_ = 0;
}

VerticalCommand Hover::command(const Surroundings& now, double step_s, const HookbehArgs& args) {
  follow(now, step_s);
  const double depth = isFinite(now.depth_m) ? depth_m_ : now.depth_m;
  const double wanted = kPumpPerMetre * (depth - target_m_) + kPumpPerMetreASecond * rate_mps_;
  if (!(magnitude(wanted - pump_cc_) <= kRestsCc)) {
    // The guard handles an unknown depth. Even so, the pump must not receive a NaN: it goes out.
    pump_cc_ = atLeast(atMost(wanted, args.climb_pump_cc), args.dive_pump_cc);
  }
  return {0, pump_cc_, Doing::Hover};
}

}  // namespace glider::hooks
