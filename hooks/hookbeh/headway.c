// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/hookbeh/headway.h"

#include "hooks/protocol/numbers.h"

/// s from the command to dive until the vehicle sinks: the pump's way, and the vehicle's inertia.
static const double kActsSecs = 30;
/// m and s; a dive whose depth changes by no more for so long has stopped. The slowest metre of a
/// dive in real logs takes 16 s.
static const double kStillM = 0.5;
static const double kStillSecs = 24;
/// s; a healthy dive shows in less time that it moves, and the second is that of guard 7.
static const double kStopsSecs = 60;
static const double kIdleSecs = 180;
/// m; no vehicle moves so far in the longest cycle: the depth before was another one.
static const double kLeapM = 8;
/// m; less is not a gain.
static const double kGainM = 1;

void hookHeadwayInit(HookHeadway* headway) {
  headway->way = kHookWayNone;
  headway->last_m = headway->best_m = headway->still_m = hookUnknown();
  headway->idle_s = headway->driven_s = headway->still_s = 0;
}

void hookHeadwayInterrupt(HookHeadway* headway) {
  headway->driven_s = headway->still_s = 0;
}

static bool standsInDive(const HookHeadway* headway) {
  return headway->way == kHookWayDown && headway->driven_s >= kActsSecs + kStillSecs &&
         headway->still_s >= kStillSecs;
}

double hookHeadwayStandsAt(const HookHeadway* headway) {
  return standsInDive(headway) ? headway->still_m : hookUnknown();
}

bool hookHeadwayMayHaveStopped(const HookHeadway* headway) {
  return headway->way == kHookWayDown &&
         (headway->driven_s >= kStopsSecs || headway->idle_s >= kIdleSecs);
}

void hookHeadwayObserve(HookHeadway* headway, HookWay way, double depth_m, double step_s) {
  const double gained = way == kHookWayDown ? depth_m - headway->best_m : headway->best_m - depth_m;
  const bool leaps = hookMagnitude(depth_m - headway->last_m) > kLeapM;
  headway->last_m = depth_m;
  if (way != headway->way || gained >= kGainM || leaps) {
    headway->best_m = depth_m;
    headway->idle_s = 0;
  } else {
    headway->idle_s += step_s;
  }
  const bool same = way == headway->way && hookMagnitude(depth_m - headway->still_m) <= kStillM;
  headway->still_m = same ? headway->still_m : depth_m;
  headway->still_s = same ? headway->still_s + step_s : 0;
  headway->driven_s = way == headway->way ? headway->driven_s + step_s : 0;
  headway->way = way;
}
