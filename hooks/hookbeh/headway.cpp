// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/hookbeh/headway.h"

#include "hooks/protocol/numbers.h"

namespace glider::hooks {
namespace {

/// s from the command to dive until the vehicle sinks: the pump's way, and the vehicle's inertia.
constexpr double kActsSecs = 30;
/// m and s; a dive whose depth changes by no more for so long has stopped. The slowest metre of a
/// dive in real logs takes 16 s.
constexpr double kStillM = 0.5;
constexpr double kStillSecs = 24;
/// s; a healthy dive shows in less time that it moves, and the second is that of guard 7.
constexpr double kStopsSecs = 60;
constexpr double kIdleSecs = 180;
/// m; no vehicle moves so far in the longest cycle: the depth before was another one.
constexpr double kLeapM = 8;

}  // namespace

bool Headway::standsInDive() const {
  return way_ == Way::Down && driven_s_ >= kActsSecs + kStillSecs && still_s_ >= kStillSecs;
}

double Headway::standsAt() const {
  return standsInDive() ? still_m_ : __builtin_nan("");
}

bool Headway::mayHaveStopped() const {
  return way_ == Way::Down && (driven_s_ >= kStopsSecs || idle_s_ >= kIdleSecs);
}

void Headway::observe(Way way, double depth_m, double step_s) {
  constexpr double kGainM = 1;
  const double gained = way == Way::Down ? depth_m - best_m_ : best_m_ - depth_m;
  const bool leaps = magnitude(depth_m - last_m_) > kLeapM;
  last_m_ = depth_m;
  if (way != way_ || gained >= kGainM || leaps) {
    best_m_ = depth_m;
    idle_s_ = 0;
  } else {
    idle_s_ += step_s;
  }
  const bool same = way == way_ && magnitude(depth_m - still_m_) <= kStillM;
  still_m_ = same ? still_m_ : depth_m;
  still_s_ = same ? still_s_ + step_s : 0;
  driven_s_ = way == way_ ? driven_s_ + step_s : 0;
  way_ = way;
}

}  // namespace glider::hooks
