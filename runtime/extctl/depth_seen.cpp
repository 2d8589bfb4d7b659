// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/extctl/depth_seen.h"

#include "hooks/protocol/numbers.h"

namespace glider::runtime::extctl {
namespace {

/// A change of depth by less, after a change the other way, may be noise or swell, m.
constexpr double kTurn = 1;
/// Above, the vehicle is at the surface, m.
constexpr double kSurface = 1;

}  // namespace

void DepthSeen::turn(double depth_m) {
  if (!climbs_) {
    deep_m_ = extreme_m_;
  }
  climbs_ = !climbs_;
  extreme_m_ = depth_m;
}

void DepthSeen::look(double depth_m) {
  if (!hookIsFinite(depth_m)) {
    return;
  }
  const double back_m = climbs_ ? depth_m - extreme_m_ : extreme_m_ - depth_m;
  if (back_m > kTurn) {
    turn(depth_m);
  } else if (back_m < 0) {
    extreme_m_ = depth_m;
  }
  const double most_m = depth_m < kSurface ? 0 : depth_m + forget_m_;
  deep_m_ = hookAtMost(hookAtLeast(depth_m, deep_m_), most_m);
}

}  // namespace glider::runtime::extctl
