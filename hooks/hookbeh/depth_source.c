// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/hookbeh/depth_source.h"

#include "hooks/protocol/numbers.h"

/// m; what noise and waves may add to the vehicle's own vertical motion.
static const double kReachM = 2.5;
/// s; until a sensor has given readings that a vehicle can follow for this long, a jump also
/// replaces the depth that later readings are compared with.
static const double kSettlesSecs = 60;
/// s; hookDepthSourcePatience() at the usual cadence, and at most; otherwise it is twice the usual
/// gap and a cycle more, because a reading may be late or come twice.
static const double kFrozenSecs = 16;
static const double kMostFrozenSecs = 36;
static const double kCycleSecs = 4;
/// m; a depth outside this range is not a valid reading of a depth sensor: it is above the surface,
/// or far below what the hull survives.
static const double kHighestDepthM = -5;
static const double kDeepestShare = 1.5;

void hookDepthSourceInit(HookDepthSource* source, const HookHull* hull) {
  source->hull = *hull;
  hookCadenceInit(&source->cadence);
  source->depth_m = source->age_s = hookUnknown();
  source->same_s = source->jumped_s = source->good_s = 0;
  source->reading = kHookDepthReadingMissing;
}

double hookDepthSourcePatience(const HookDepthSource* source) {
  return hookBetween(2 * source->cadence.usual_s + kCycleSecs, kFrozenSecs, kMostFrozenSecs);
}

static bool isDepth(double depth_m, const HookHull* hull) {
  return depth_m >= kHighestDepthM && depth_m <= kDeepestShare * hull->greatest_depth_m;
}

/// Of a cycle in which the reading has jumped, s. One reading counts no longer than a usual cycle,
/// however long the sensor array keeps it: it may be a single false one.
static double countedSecs(const HookDepthSource* source, double step_s) {
  const bool kept = !source->cadence.is_new && source->cadence.since_s <= source->cadence.usual_s;
  return kept ? 0 : source->cadence.is_new ? hookAtMost(step_s, kCycleSecs) : step_s;
}

void hookDepthSourceObserve(HookDepthSource* source, double depth_m, double step_s) {
  source->age_s += step_s;
  if (!isDepth(depth_m, &source->hull)) {
    hookCadenceObserve(&source->cadence, hookUnknown(), step_s);
    source->reading = kHookDepthReadingMissing;
    return;
  }
  hookCadenceObserve(&source->cadence, depth_m, step_s);
  source->same_s = source->cadence.is_new ? 0 : source->same_s + step_s;
  // The sensor array keeps a reading until there is a newer one, and the vehicle moves meanwhile.
  const bool rare =
      !hookCadenceIsKnown(&source->cadence) || hookDepthSourcePatience(source) > kFrozenSecs;
  const double most_s = rare ? kMostFrozenSecs : kFrozenSecs;
  const double since_s = hookAtLeast(source->age_s, hookAtMost(source->cadence.since_s, most_s));
  const double moved = hookMagnitude(depth_m - source->depth_m);
  // The very first reading is compared with a NaN, and is good.
  if (moved > kReachM + source->hull.vertical_rate_m_s * since_s) {
    source->reading = kHookDepthReadingJumped;
    source->jumped_s += countedSecs(source, step_s);
    if (source->good_s < kSettlesSecs) {
      source->depth_m = depth_m;
      source->age_s = 0;
    }
    return;
  }
  source->reading = kHookDepthReadingGood;
  source->depth_m = depth_m;
  source->age_s = 0;
  source->good_s += step_s;
  source->jumped_s = hookAtLeast(source->jumped_s - step_s / 2, 0);
}
