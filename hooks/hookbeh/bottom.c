// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/hookbeh/bottom.h"

#include "hooks/protocol/numbers.h"

/// m; a vehicle stays this much more above a bottom that it has touched: it turns no sooner.
static const double kMarginM = 2;
/// m; a dive shorter than this is not one: a guard's least climb, and its clearance.
static const double kLeastDiveM = 6;
/// m; a stop was one on the bottom if the vehicle then climbs this far as its depth shows.
static const double kClimbsM = 2.5;
/// m; meanwhile the depth does not show that it sinks, nor in swell of a metre, and makes no step.
static const double kSinksM = 2.5;
static const double kStepM = 1.5;
static const double kStepMps = 0.5;
static const double kGapSecs = 36;
/// s and m; a stop so long after another one is that of another dive, and in between the depth of a
/// vehicle that climbed has changed by more.
static const double kAnotherDiveSecs = 54;
static const double kFollowsM = 1;
/// m; at the surface an old echo lets the vehicle dive so far that it can use the altimeter.
static const double kTriesM = 10;
/// m; a dive that has risen by so much is over.
static const double kTurnedM = 3;
/// s; an echo this recent shows the bottom by itself.
static const double kRecentSecs = 60;
/// m; an echo agrees with a contact within this; it is believed again after so many that do, over
/// so great a range of depths: a stuck altimeter agrees at one depth only.
static const double kAgreesM = 2.5;
static const double kAgreeing = 3;
static const double kAgreesOverM = 8;

void hookBottomInit(HookBottom* bottom) {
  hookEchoFloorInit(&bottom->echoes);
  hookBottomMemoryInit(&bottom->memory);
  bottom->depth_m = bottom->dive_m = bottom->stop_m = bottom->stuck_m = hookUnknown();
  bottom->agrees_from_m = bottom->agrees_to_m = hookUnknown();
  bottom->sinks = bottom->believed = true;
  bottom->top_m = bottom->stop_last_m = bottom->agreed = 0;
  bottom->stop_gap_s = bottom->stop_age_s = bottom->stop_far_m = 0;
  bottom->failed = false;
}

void hookBottomMove(HookBottom* bottom, const HookSurroundings* now, double least_altitude_m,
                    double step_s) {
  const HookPosition here = {now->latitude_ddmm, now->longitude_ddmm};
  const double shallow_m = hookAtLeast(least_altitude_m + kMarginM + kLeastDiveM, kHookShallowM);
  hookBottomMemoryObserve(&bottom->memory, here, shallow_m, step_s);
}

/// An altimeter that contradicted a contact is believed again once it agrees with it.
static void judgeEcho(HookBottom* bottom, double depth_m) {
  if (bottom->failed) {
    hookBottomMemoryForgetEchoes(&bottom->memory);
    bottom->failed = false;
  }
  const double touched = hookBottomMemoryTouchedHere(&bottom->memory);
  if (bottom->believed || !hookIsFinite(touched)) {
    return;
  }
  if (hookMagnitude(bottom->echoes.bottom_m - touched) > kAgreesM) {
    bottom->agreed = 0;
    return;
  }
  bottom->agrees_from_m =
      bottom->agreed == 0 ? depth_m : hookAtMost(depth_m, bottom->agrees_from_m);
  bottom->agrees_to_m = bottom->agreed == 0 ? depth_m : hookAtLeast(depth_m, bottom->agrees_to_m);
  bottom->agreed += 1;
  bottom->believed =
      bottom->agreed >= kAgreeing && bottom->agrees_to_m - bottom->agrees_from_m >= kAgreesOverM;
}

void hookBottomObserve(HookBottom* bottom, const HookSurroundings* now, double depth_m,
                       double least_altitude_m, double step_s) {
  bottom->depth_m = depth_m;
  hookEchoFloorObserve(&bottom->echoes, depth_m, now->altitude_m, least_altitude_m + kTriesM,
                       step_s);
  if (bottom->echoes.heard) {
    judgeEcho(bottom, depth_m);
  }
  if (!bottom->failed && hookEchoFloorHasFailed(&bottom->echoes)) {
    hookBottomMemoryKeepEcho(&bottom->memory, bottom->echoes.bottom_m);
    bottom->failed = true;
  }
}

void hookBottomNoteStop(HookBottom* bottom) {
  const bool again = hookIsFinite(bottom->stop_m) && bottom->stop_age_s >= kAnotherDiveSecs;
  bottom->stuck_m = again && bottom->stop_far_m < kFollowsM ? bottom->depth_m : bottom->stuck_m;
  bottom->stop_age_s = again || !hookIsFinite(bottom->stop_m) ? 0 : bottom->stop_age_s;
  bottom->stop_m = hookIsFinite(bottom->stuck_m) ? hookUnknown() : bottom->depth_m;
  bottom->stop_last_m = bottom->depth_m;
  bottom->stop_gap_s = bottom->stop_far_m = 0;
}

static void confirmStop(HookBottom* bottom) {
  const bool steps =
      hookMagnitude(bottom->depth_m - bottom->stop_last_m) > kStepM + kStepMps * bottom->stop_gap_s;
  if (steps || bottom->stop_gap_s > kGapSecs || bottom->depth_m > bottom->stop_m + kSinksM) {
    bottom->stop_m = hookUnknown();
    return;
  }
  bottom->stop_last_m = bottom->depth_m;
  bottom->stop_gap_s = 0;
  if (bottom->stop_m - bottom->depth_m >= kClimbsM) {
    const bool contradicts = !(bottom->echoes.silent_s <= kRecentSecs &&
                               hookMagnitude(bottom->echoes.bottom_m - bottom->stop_m) <= kAgreesM);
    bottom->believed = bottom->believed && !contradicts;
    bottom->agreed = 0;
    hookBottomMemoryTouch(&bottom->memory, bottom->stop_m);
    bottom->stop_m = hookUnknown();
  }
}

/// Follows the dives: each one's greatest depth, until the vehicle has turned.
static void noteTurn(HookBottom* bottom, double depth_m) {
  if (bottom->sinks) {
    if (!(depth_m < bottom->dive_m)) {
      bottom->dive_m = depth_m;
    } else if (bottom->dive_m - depth_m > kTurnedM) {
      hookBottomMemoryNoteDive(&bottom->memory, bottom->dive_m);
      bottom->sinks = false;
      bottom->top_m = depth_m;
    }
    return;
  }
  bottom->top_m = hookAtMost(depth_m, bottom->top_m);
  if (depth_m - bottom->top_m > kTurnedM) {
    bottom->dive_m = depth_m;
    bottom->sinks = true;
  }
}

void hookBottomFollow(HookBottom* bottom, double step_s) {
  bottom->stop_gap_s += step_s;
  bottom->stop_age_s += step_s;
  if (!hookIsFinite(bottom->depth_m)) {
    return;
  }
  bottom->stop_far_m =
      hookAtLeast(hookMagnitude(bottom->depth_m - bottom->stop_m), bottom->stop_far_m);
  if (hookMagnitude(bottom->depth_m - bottom->stuck_m) > kClimbsM) {
    bottom->stuck_m = hookUnknown();
  }
  // The sensor array keeps a reading until there is a newer one.
  if (hookIsFinite(bottom->stop_m) && bottom->depth_m != bottom->stop_last_m) {
    confirmStop(bottom);
  }
  noteTurn(bottom,
           bottom->depth_m);  // afterwards: until then the dive before is the one before the stop
}

double hookBottomTouchedFloor(const HookBottom* bottom) {
  return hookBottomMemoryFloor(&bottom->memory, true) - kMarginM;
}

double hookBottomFloor(const HookBottom* bottom) {
  const bool shows = bottom->believed && bottom->echoes.silent_s <= kRecentSecs;
  return shows ? bottom->echoes.floor_m
               : hookAtMost(hookBottomMemoryFloor(&bottom->memory, false) - kMarginM,
                            bottom->echoes.floor_m);
}
