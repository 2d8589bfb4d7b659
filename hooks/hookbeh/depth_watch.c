// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/hookbeh/depth_watch.h"

#include "hooks/protocol/numbers.h"

/// m; in real logs m_depth and the CTD's depth differ by 2.1 m at most, lag included.
static const double kAgreeM = 5;
/// s; a disagreement or a jump must last this long before it counts.
static const double kPersistsSecs = 10;
/// s; a CTD without a reading for longer counts as absent.
static const double kCtdLastsSecs = 20;
/// m; a sensor is frozen if it does not change for its patience() while the other moves this far.
static const double kWatchMovesM = 3;
/// s; the patience with a sensor that gives a reading in each cycle.
static const double kUsualPatienceSecs = 16;
/// s; the same in hover, where the vehicle may hardly move.
static const double kFrozenHoverSecs = 60;
/// cc; with less, the pump only trims the vehicle.
static const double kDrivesCc = 100;
/// m; above this depth m_depth may be clipped: it is never negative.
static const double kWatchClippedM = 1;
/// m; the CTD's depth changes by less in a vehicle that does not move.
static const double kWatchStillM = 0.5;
/// After this many seconds without a doubt the depth is believed again. Below, in m: the depth at
/// the surface.
static const double kQuietSecs = 60;
static const double kSurfacedM = 3;
static const double kClimbedSecs = 120;

void hookDepthWatchInit(HookDepthWatch* watch, const HookHull* hull) {
  watch->hull = *hull;
  hookDepthSourceInit(&watch->own, hull);
  hookRecentDepthsInit(&watch->own_lately);
  hookDepthSourceInit(&watch->ctd, hull);
  watch->ctd_is_new = watch->ctd_jumped = watch->own_jumped = watch->ctd_frozen = false;
  watch->differs = watch->ctd_known = watch->frozen = false;
  watch->own_at_ctd_change_m = watch->ctd_at_own_change_m = hookUnknown();
  watch->agree_s = watch->disagree_s = watch->alive_s = 0;
  watch->blind = kHookGuardNone;
  watch->quiet_s = watch->climbed_s = 0;
}

void hookDepthWatchBelieveCtd(HookDepthWatch* watch) {
  watch->ctd_known = true;
}

/// True if it gives readings, and they change when the vehicle moves.
static bool ctdLives(const HookDepthWatch* watch) {
  return watch->ctd.age_s <= kCtdLastsSecs && !watch->ctd_jumped && !watch->ctd_frozen;
}

static void watchCtd(HookDepthWatch* watch, double step_s) {
  const bool moved = hookMagnitude(watch->own.depth_m - watch->own_at_ctd_change_m) >= kWatchMovesM;
  watch->ctd_frozen = (watch->ctd_frozen && !watch->ctd_is_new) ||
                      (watch->ctd.same_s >= hookDepthSourcePatience(&watch->ctd) && moved);
  const bool own_good = watch->own.reading == kHookDepthReadingGood;
  const double apart = hookRecentDepthsDistanceTo(&watch->own_lately, watch->ctd.depth_m);
  const bool agrees = watch->ctd.age_s == 0 && apart <= kAgreeM;
  watch->ctd_jumped =
      watch->ctd.reading == kHookDepthReadingJumped || (watch->ctd_jumped && !(own_good && agrees));
  if (!ctdLives(watch)) {
    watch->agree_s = watch->disagree_s = 0;
    return;
  }
  if (!own_good) {
    watch->agree_s = 0;
    return;
  }
  // An old reading of either does not show where the vehicle is now. While the sensor array keeps
  // the vehicle's own, only a distance that the vehicle cannot have moved meanwhile counts.
  const double kept_s =
      hookAtMost(watch->own.same_s, hookDepthSourcePatience(&watch->own) - kUsualPatienceSecs);
  const bool beyond = apart > kAgreeM + watch->hull.vertical_rate_m_s * kept_s;
  if (watch->ctd.age_s == 0 && (agrees || beyond)) {
    watch->differs = !agrees;
  }
  watch->agree_s = watch->differs ? 0 : watch->agree_s + step_s;
  watch->disagree_s = watch->differs ? watch->disagree_s + step_s : 0;
  // One that is off by some metres agrees with a depth of some seconds ago, but not with this one.
  const bool here = hookMagnitude(watch->own.depth_m - watch->ctd.depth_m) <= kAgreeM;
  watch->ctd_known = watch->ctd_known || (watch->agree_s >= kPersistsSecs && here);
}

static void watchFrozen(HookDepthWatch* watch, double pump_cc) {
  const bool driven = pump_cc >= kDrivesCc || pump_cc <= -kDrivesCc;
  const double patience = driven ? hookDepthSourcePatience(&watch->own) : kFrozenHoverSecs;
  const bool same =
      hookIsFinite(pump_cc) && watch->own.same_s >= patience && watch->own.depth_m > kWatchClippedM;
  // The vehicle itself does not move, as another working sensor shows.
  const bool hangs = ctdLives(watch) && watch->ctd.same_s < hookDepthSourcePatience(&watch->ctd) &&
                     hookMagnitude(watch->ctd.depth_m - watch->ctd_at_own_change_m) < kWatchStillM;
  watch->frozen = (watch->frozen && watch->own.same_s > 0) || (same && !hangs);
}

static void watchLife(HookDepthWatch* watch, double step_s) {
  const bool lives = watch->own.reading == kHookDepthReadingGood &&
                     watch->own.same_s < hookDepthSourcePatience(&watch->own);
  watch->alive_s = lives || watch->agree_s > 0 ? watch->alive_s + step_s : 0;
}

static HookGuard worstDoubt(const HookDepthWatch* watch) {
  // A disagreement counts only with a CTD reading of this cycle: a CTD that falls silent has none.
  const bool disagree =
      watch->ctd_known && watch->disagree_s >= kPersistsSecs && watch->ctd.age_s == 0;
  return watch->own.jumped_s >= kPersistsSecs ? kHookGuardDepthJumps
         : watch->frozen                      ? kHookGuardDepthFrozen
         : disagree                           ? kHookGuardDepthsDisagree
                                              : kHookGuardNone;
}

/// True if no fault is detectable in this cycle.
static bool isQuiet(const HookDepthWatch* watch) {
  const bool lives = watch->own.same_s < hookDepthSourcePatience(&watch->own) ||
                     watch->own.depth_m <= kWatchClippedM;
  return watch->own.reading == kHookDepthReadingGood && lives && watch->disagree_s == 0;
}

static void settleDoubt(HookDepthWatch* watch, const HookSurroundings* now, double step_s,
                        double pump_cc) {
  const HookGuard found = worstDoubt(watch);
  if (found != kHookGuardNone) {
    // A depth that has jumped stays marked so: a lesser doubt must not make it believed sooner.
    watch->blind = watch->blind == kHookGuardDepthJumps ? watch->blind : found;
    watch->quiet_s = 0;
    watch->climbed_s = 0;
    return;
  }
  watch->quiet_s = isQuiet(watch) ? watch->quiet_s + step_s : 0;
  watch->climbed_s += pump_cc > 0 ? step_s : 0;
  const bool surfaced = now->depth_m <= kSurfacedM && watch->climbed_s >= kClimbedSecs;
  // Two sensors that agree are believed. One that was frozen is believed only where its reading is
  // known to be right: at the surface. One that has jumped may be wrong there too.
  const bool two = watch->agree_s >= kQuietSecs && watch->blind != kHookGuardDepthsDisagree;
  const bool one = surfaced && watch->blind != kHookGuardDepthJumps;
  if (watch->quiet_s >= kQuietSecs && (two || one)) {
    watch->blind = kHookGuardNone;
  }
}

void hookDepthWatchObserve(HookDepthWatch* watch, const HookSurroundings* now, double step_s,
                           double pump_cc) {
  hookDepthSourceObserve(&watch->own, now->depth_m, step_s);
  hookDepthSourceObserve(&watch->ctd, now->ctd_depth_m, step_s);
  hookRecentDepthsObserve(
      &watch->own_lately,
      watch->own.reading == kHookDepthReadingGood ? watch->own.depth_m : hookUnknown(), step_s);
  watch->ctd_is_new = watch->ctd.age_s == 0 && watch->ctd.same_s == 0;
  if (watch->own.same_s == 0) {
    watch->ctd_at_own_change_m = watch->ctd.depth_m;
  }
  // A vehicle does not move by a jump: a CTD that says the same before and after it is not frozen.
  // Nor does a depth that is not believed show that it moves: at the surface a CTD rests.
  const bool own_jumps = watch->own.reading == kHookDepthReadingJumped ||
                         (watch->blind != kHookGuardNone && watch->ctd.depth_m < kWatchClippedM);
  if (watch->ctd_is_new || own_jumps || watch->own_jumped) {
    watch->own_at_ctd_change_m = watch->own.depth_m;
  }
  watch->own_jumped = own_jumps;
  watchCtd(watch, step_s);
  watchFrozen(watch, pump_cc);
  watchLife(watch, step_s);
  settleDoubt(watch, now, step_s, pump_cc);
}

HookGuard hookDepthWatchDoubt(const HookDepthWatch* watch) {
  return watch->own.reading == kHookDepthReadingMissing  ? kHookGuardDepthUnknown
         : watch->own.reading == kHookDepthReadingJumped ? kHookGuardDepthJumps
                                                         : watch->blind;
}

double hookDepthWatchDepth(const HookDepthWatch* watch) {
  return hookDepthWatchDoubt(watch) == kHookGuardNone ? watch->own.depth_m : hookUnknown();
}

bool hookDepthWatchIsSeenByAnother(const HookDepthWatch* watch) {
  return watch->agree_s > 0 && watch->ctd_is_new;
}

double hookDepthWatchCtdDepth(const HookDepthWatch* watch) {
  return watch->ctd.reading == kHookDepthReadingGood ? watch->ctd.depth_m : hookUnknown();
}

double hookDepthWatchDeepest(const HookDepthWatch* watch) {
  const bool ctd_counts = watch->ctd_known && ctdLives(watch) && watch->ctd.age_s == 0;
  return ctd_counts ? hookAtLeast(watch->ctd.depth_m, watch->own.depth_m) : watch->own.depth_m;
}
