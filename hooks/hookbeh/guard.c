// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/hookbeh/guard.h"

#include "hooks/protocol/numbers.h"

static const double kClearM = 1.0;
/// After a dive that broke a limit, the guard makes the vehicle climb by this share of the depth
/// where it stepped in, and by at least this many metres, before the dive may be tried again.
/// Without that the pump would never rest.
static const double kRetryShare = 0.5;
static const double kRetryM = 5.0;
/// m; the altitude over a bottom that it has touched, for a vehicle that uses no altimeter.
static const double kWithoutAltimeterM = 3;
/// s; how long the vehicle sinks on after it has been commanded to climb. Below, in m/s: the
/// fastest that it sinks; a rate above that is false.
static const double kTurnsSecs = 8;
static const double kFastestMps = 0.5;
/// s without a metre gained: the defaults of the vendor's dive_to and climb_to
/// (stop_when_hover_for, stop_when_stalled_for).
static const double kHoverSecs = 180;
static const double kStalledSecs = 240;
/// m that the vehicle may sink unseen even at its greatest depth: a smaller value would end a dive
/// that waves or a layer slow down. The slowest metre of a dive in real logs takes 16 s.
static const double kLeastUnseenM = 7;
/// m; a dive ends if it may be this far past its target, and this far past the depth last shown.
static const double kPastTargetM = 8;
static const double kPastShownM = 10;
/// m; the same before the depth has moved at all.
static const double kMostUnseenAtFirstM = 20;
/// Two sensors may be wrong: how far one dive may lead past the greatest depth, as a share of it;
/// below, the least such distance in metres, in the dive and at the steepest pitch.
static const double kPastShare = 0.44;
static const double kLeastInDiveM = 11;
static const double kLeastSteeplyM = 18;
/// At the steepest possible pitch the vehicle is assumed to sink so many times as fast as usual.
static const double kSteeplyTimes = 1.7;
/// m; a vehicle that may have sunk so far since its depth last answered climbs to see whether it
/// does: the distance to the greatest depth, between these. At 0.1 m/s, 300 and 600 s of hover.
static const double kAsksM = 30;
static const double kAsksLatestM = 60;
/// s; a depth below the second, in m, that does not answer to a climb of this length is not
/// believed.
static const double kAnswersSecs = 180;
static const double kAnswersBelowM = 3;
/// m; a vehicle that has just left the depth where it stood is within this distance of it.
static const double kStoodNearM = 2;
/// m; at this depth or above, the vehicle is at the surface.
static const double kAtSurfaceM = 1;
/// s of climbing after a dive that gained no depth, and s for which the sensor must have worked:
/// then it is believed again.
static const double kHomeSecs = 600;
static const double kAliveSecs = 60;
/// s; the longest until a depth that repeats its zero at the surface is tried again.
static const double kMostHomeSecs = 7200;

void hookbehGuardInit(HookbehGuard* guard, const HookHull* hull) {
  hookDepthWatchInit(&guard->watch, hull);
  hookHeadwayInit(&guard->headway);
  hookUnseenSinkInit(&guard->unseen, hull);
  hookUnseenSinkInit(&guard->by_ctd, hull);
  hookBottomInit(&guard->bottom);
  guard->floor_m = guard->touched_floor_m = kHookBottomless;
  guard->shows = guard->asks = guard->doubted = false;
  guard->sinks_mps = guard->tries_after_s = 0;
  guard->depth_m = guard->tripped_depth_m = guard->tripped_s = hookUnknown();
  guard->down_from_m = hookUnknown();
  guard->tripped = kHookGuardNone;
}

void hookbehGuardObserve(HookbehGuard* guard, const HookbehArgs* args, const HookSurroundings* now,
                         double step_s, const HookVerticalCommand* last, HookWay way) {
  hookDepthWatchObserve(&guard->watch, now, step_s, last->pump_cc);
  guard->depth_m = hookDepthWatchDeepest(&guard->watch);
  const bool known = hookDepthWatchDoubt(&guard->watch) == kHookGuardNone;
  const double stood_m = hookHeadwayStandsAt(&guard->headway);
  if (known && !guard->doubted) {  // an occasional missing reading must not clear it
    hookHeadwayObserve(&guard->headway, way, hookDepthWatchDepth(&guard->watch), step_s);
  } else {
    hookHeadwayInterrupt(&guard->headway);
  }
  // In any way that the dive ended; but a depth that is believed again may be another one.
  if (guard->headway.way != kHookWayDown &&
      hookMagnitude(hookDepthWatchDepth(&guard->watch) - stood_m) <= kStoodNearM) {
    hookBottomNoteStop(&guard->bottom);
  }
  hookUnseenSinkObserve(&guard->unseen, hookDepthWatchDepth(&guard->watch), step_s, last);
  const double deepest = guard->unseen.deepest_m;
  guard->down_from_m = way == kHookWayDown ? hookAtMost(deepest, guard->down_from_m) : deepest;
  hookUnseenSinkObserve(&guard->by_ctd, hookDepthWatchCtdDepth(&guard->watch), step_s, last);
  if (guard->by_ctd.has_moved && !guard->unseen.has_moved) {
    hookDepthWatchBelieveCtd(&guard->watch);  // the CTD works, and the depth sensor does not
  }
  if (hookDepthWatchIsSeenByAnother(&guard->watch)) {
    hookUnseenSinkConfirm(&guard->unseen, hookDepthWatchDepth(&guard->watch));
  }
  guard->tripped_s += step_s;
  guard->sinks_mps =
      hookIsFinite(now->depth_rate_mps) ? hookBetween(now->depth_rate_mps, 0, kFastestMps) : 0;
  hookBottomMove(&guard->bottom, now, args->least_altitude_m, step_s);
  hookBottomObserve(&guard->bottom, now, hookDepthWatchDepth(&guard->watch), args->least_altitude_m,
                    step_s);
  hookBottomFollow(&guard->bottom, step_s);
  guard->floor_m = hookBottomFloor(&guard->bottom);
  guard->touched_floor_m = hookBottomTouchedFloor(&guard->bottom);
}

void hookbehGuardReset(HookbehGuard* guard) {
  // A vehicle that could not detect that it sinks cannot detect it for another SBC either.
  if (guard->tripped != kHookGuardNoDepthGained) {
    guard->tripped = kHookGuardNone;
  }
}

/// How deep the vehicle may be before its depth must show it, m.
static double mostUnseen(const HookbehGuard* guard, const HookbehArgs* args,
                         const HookInstruction* in_force) {
  const double shown = guard->unseen.shown_m;
  const double late = hookUnseenSinkLateBy(&guard->unseen);
  double most = hookAtLeast(shown + kLeastUnseenM + late, args->greatest_depth_m);
  if (!guard->unseen.has_moved) {
    most = hookAtMost(shown + kMostUnseenAtFirstM, most);
  }
  if (in_force->vertical == kHookVerticalDescend) {
    most =
        hookAtMost(hookAtLeast(in_force->depth_m + kPastTargetM, shown + kPastShownM) + late, most);
  }
  return most;
}

/// True if the dive itself may have led past all limits, even against a second sensor: both may be
/// wrong.
static bool mayBeFarDown(const HookbehGuard* guard, const HookbehArgs* args) {
  const double left =
      args->greatest_depth_m - guard->unseen.shown_m + kPastShare * args->greatest_depth_m;
  const double late = hookUnseenSinkLateBy(&guard->unseen);
  return guard->unseen.in_dive_m >= hookAtLeast(left, kLeastInDiveM) + late ||
         guard->unseen.steeply_m >= hookAtLeast(left, kLeastSteeplyM) + kSteeplyTimes * late;
}

static bool mayBeDeeper(const HookbehGuard* guard, const HookbehArgs* args,
                        const HookInstruction* in_force) {
  return guard->unseen.deepest_m >= mostUnseen(guard, args, in_force) || mayBeFarDown(guard, args);
}

/// True if the vehicle must climb to see whether its depth answers, whoever agrees with it: what
/// sticks in one sensor of pressure may stick in the other. Until it answers, or the vehicle must
/// be at the surface.
static bool mustAsk(HookbehGuard* guard, const HookbehArgs* args) {
  const double most =
      hookBetween(args->greatest_depth_m - guard->unseen.answered_m, kAsksM, kAsksLatestM);
  // A dive and a climb have rules of their own.
  const bool adrift = guard->headway.way == kHookWayNone && guard->unseen.unanswered_m >= most;
  guard->asks = adrift || (guard->asks && guard->unseen.unanswered_m > 0);
  return guard->asks;
}

bool hookbehGuardMustShowDepth(HookbehGuard* guard, const HookbehArgs* args,
                               const HookInstruction* in_force) {
  guard->shows = mayBeDeeper(guard, args, in_force) ||
                 (guard->shows && guard->unseen.deepest_m > guard->unseen.shown_m);
  return mustAsk(guard, args) || guard->shows;
}

static bool isDepthDoubt(HookGuard guard) {
  return guard == kHookGuardDepthUnknown || guard == kHookGuardDepthJumps;
}

static bool clearOfBottom(const HookbehGuard* guard, const HookbehArgs* args, double depth_m) {
  const bool by_echo = !(args->least_altitude_m < 0);
  const double floor_m = by_echo ? guard->floor_m : guard->touched_floor_m;
  const double least = by_echo ? args->least_altitude_m : kWithoutAltimeterM;
  return !hookIsFloorKnown(floor_m) || floor_m - depth_m >= least;
}

/// A depth to fly to.
static bool hasTarget(const HookInstruction* in_force) {
  return in_force->vertical == kHookVerticalDescend || in_force->vertical == kHookVerticalAscend ||
         in_force->vertical == kHookVerticalHover;
}

static bool keepsLimits(const HookbehGuard* guard, const HookbehArgs* args, double depth_m) {
  return depth_m <= args->greatest_depth_m && clearOfBottom(guard, args, depth_m);
}

static bool mayGoOn(const HookbehGuard* guard, const HookbehArgs* args,
                    const HookInstruction* in_force) {
  if (in_force->vertical == kHookVerticalActuators) {
    return false;  // wherever they lead
  }
  // This also holds for an ascend: once the vehicle is above its target, hovering there leads down.
  return !hasTarget(in_force) || keepsLimits(guard, args, in_force->depth_m + kClearM);
}

/// True if the vehicle sinks towards a target that is too near the bottom, and would be too near it
/// before it has turned. At a target that is clear of the bottom it turns by itself.
static bool sinksTooNear(const HookbehGuard* guard, const HookbehArgs* args,
                         const HookInstruction* in_force) {
  return !clearOfBottom(guard, args, guard->depth_m + kTurnsSecs * guard->sinks_mps) &&
         !mayGoOn(guard, args, in_force);
}

static HookGuard brokenLimit(const HookbehGuard* guard, const HookbehArgs* args,
                             const HookInstruction* in_force) {
  // All comparisons are written so that a NaN among the b_args counts as a broken limit.
  return !(guard->depth_m <= args->greatest_depth_m) ? kHookGuardTooDeep
         : !clearOfBottom(guard, args, guard->depth_m) || sinksTooNear(guard, args, in_force)
             ? kHookGuardNearBottom
             : kHookGuardNone;
}

static void tripOn(HookbehGuard* guard, HookGuard broken) {
  if (broken == kHookGuardNoDepthGained && guard->tripped != broken) {
    guard->tries_after_s = hookBetween(2 * guard->tries_after_s, kHomeSecs, kMostHomeSecs);
  }
  if (guard->tripped == kHookGuardNone) {
    guard->tripped_s = 0;
  }
  if (guard->tripped == kHookGuardNone || guard->depth_m < guard->tripped_depth_m) {
    guard->tripped_depth_m = guard->depth_m;
  }
  guard->tripped = broken;
}

static HookGuard findStall(const HookbehGuard* guard, const HookbehArgs* args,
                           const HookInstruction* in_force) {
  if (guard->asks && guard->unseen.out_s >= kAnswersSecs && guard->depth_m > kAnswersBelowM) {
    return kHookGuardNoDepthGained;  // no sensor follows the vehicle
  }
  if (guard->headway.way == kHookWayUp) {
    return guard->headway.idle_s >= kStalledSecs ? kHookGuardNoHeightGained : kHookGuardNone;
  }
  const double most = mostUnseen(guard, args, in_force);
  // What it may have sunk before this dive is left to a climb that checks the depth.
  const double own =
      hookAtMost(most - guard->unseen.shown_m, kPastShownM + hookUnseenSinkLateBy(&guard->unseen));
  const bool sinks =
      guard->unseen.deepest_m >= most && !(guard->unseen.deepest_m < guard->down_from_m + own);
  const bool ends = guard->headway.idle_s >= kHoverSecs || sinks || mayBeFarDown(guard, args);
  return guard->headway.way == kHookWayDown && ends ? kHookGuardNoDepthGained : kHookGuardNone;
}

static bool hasClimbedFar(const HookbehGuard* guard) {
  return guard->tripped_depth_m - guard->depth_m >=
         hookAtLeast(kRetryShare * guard->tripped_depth_m, kRetryM);
}

static bool mayRelease(const HookbehGuard* guard, const HookbehArgs* args,
                       const HookInstruction* in_force) {
  if (guard->tripped == kHookGuardNoDepthGained) {
    const bool alive = guard->tripped_s >= kHomeSecs && guard->watch.alive_s >= kAliveSecs;
    // At the surface a depth that works may repeat its zero, and so may one that is stuck: it is
    // tried again, more and more rarely.
    const bool tries = guard->tripped_s >= guard->tries_after_s && guard->depth_m <= 0;
    return hasClimbedFar(guard) || ((alive || tries) && guard->unseen.deepest_m <= kAtSurfaceM);
  }
  if (guard->tripped == kHookGuardNoHeightGained) {
    const bool there =
        in_force->vertical == kHookVerticalActuators && guard->depth_m <= kAtSurfaceM;
    return guard->tripped_depth_m - guard->depth_m >= kClearM || there ||
           (hasTarget(in_force) && in_force->depth_m > guard->depth_m);
  }
  // At the surface it can climb no farther, wherever the limit was broken.
  const bool up = guard->depth_m <= kAtSurfaceM && keepsLimits(guard, args, kRetryM + kClearM);
  return keepsLimits(guard, args, guard->depth_m + kClearM) &&
         (mayGoOn(guard, args, in_force) || hasClimbedFar(guard) || up);
}

HookGuard hookbehGuardMustClimb(HookbehGuard* guard, const HookbehArgs* args,
                                const HookInstruction* in_force) {
  const HookGuard doubt = hookDepthWatchDoubt(&guard->watch);
  guard->doubted = isDepthDoubt(doubt);
  if (guard->doubted) {
    return doubt;
  }
  const HookGuard broken = brokenLimit(guard, args, in_force);
  // A vehicle that climbs after a dive that stopped has just learned where the bottom is.
  const bool learned = broken == kHookGuardNearBottom && guard->tripped == kHookGuardNoDepthGained;
  if (broken != kHookGuardNone && !learned) {
    tripOn(guard, broken);
    return doubt != kHookGuardNone ? doubt : guard->tripped;
  }
  const HookGuard stalled = findStall(guard, args, in_force);
  if (stalled != kHookGuardNone) {
    // A dive that has just begun again may only have gone on unseen before.
    if (stalled == kHookGuardNoDepthGained && guard->tripped != stalled &&
        hookHeadwayMayHaveStopped(&guard->headway)) {
      hookBottomNoteStop(&guard->bottom);
    }
    tripOn(guard, stalled);
  } else if (mayRelease(guard, args, in_force)) {
    guard->tries_after_s = hasClimbedFar(guard) ? 0 : guard->tries_after_s;
    guard->tripped = kHookGuardNone;
  }
  return doubt != kHookGuardNone ? doubt : guard->tripped;
}
