// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/hookbeh/depth_source.h"

#include "hooks/protocol/numbers.h"

namespace glider::hooks {
namespace {

/// m; what noise and waves may add to the vehicle's own vertical motion.
constexpr double kReachM = 2.5;
/// s; until a sensor has given readings that a vehicle can follow for this long, a jump also
/// replaces the depth that later readings are compared with.
constexpr double kSettlesSecs = 60;
/// s; patience() at the usual cadence, and at most; otherwise it is twice the usual gap and a cycle
/// more, because a reading may be late or come twice.
constexpr double kFrozenSecs = 16;
constexpr double kMostFrozenSecs = 36;
constexpr double kCycleSecs = 4;

bool isDepth(double depth_m, const Hull& hull) {
  return depth_m >= kHighestDepthM && depth_m <= kDeepestShare * hull.greatest_depth_m;
}

}  // namespace

double DepthSource::patience() const {
  return between(2 * cadence_.usual() + kCycleSecs, kFrozenSecs, kMostFrozenSecs);
}

/// Of a cycle in which the reading has jumped, s. One reading counts no longer than a usual cycle,
/// however long the sensor array keeps it: it may be a single false one.
double DepthSource::counted(double step_s) const {
  const bool kept = !cadence_.isNew() && cadence_.gap() <= cadence_.usual();
  return kept ? 0 : cadence_.isNew() ? atMost(step_s, kCycleSecs) : step_s;
}

void DepthSource::observe(double depth_m, double step_s) {
  age_s_ += step_s;
  if (!isDepth(depth_m, hull_)) {
    cadence_.observe(__builtin_nan(""), step_s);
    reading_ = Reading::Missing;
    return;
  }
  cadence_.observe(depth_m, step_s);
  same_s_ = cadence_.isNew() ? 0 : same_s_ + step_s;
  // The sensor array keeps a reading until there is a newer one, and the vehicle moves meanwhile.
  const bool rare = !cadence_.isKnown() || patience() > kFrozenSecs;
  const double most_s = rare ? kMostFrozenSecs : kFrozenSecs;
  const double since_s = atLeast(age_s_, atMost(cadence_.gap(), most_s));
  const double moved = magnitude(depth_m - depth_m_);
  // The very first reading is compared with a NaN, and is good.
  if (moved > kReachM + hull_.vertical_rate_m_s * since_s) {
    reading_ = Reading::Jumped;
    jumped_s_ += counted(step_s);
    if (good_s_ < kSettlesSecs) {
      depth_m_ = depth_m;
      age_s_ = 0;
    }
    return;
  }
  reading_ = Reading::Good;
  depth_m_ = depth_m;
  age_s_ = 0;
  good_s_ += step_s;
  jumped_s_ = atLeast(jumped_s_ - step_s / 2, 0);
}

}  // namespace glider::hooks
