// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/hookbeh/echo_floor.h"

#include "hooks/hookbeh/bottom_memory.h"
#include "hooks/protocol/numbers.h"

/// s; for so long after an echo the bottom stays where it was.
static const double kFreshSecs = 40;
/// s; for so long it may rise; after that an echo counts less and less.
static const double kLastsSecs = 1200;
/// s; an echo of so shallow a bottom that the vehicle cannot dive, and so cannot fly away, is
/// forgotten after this time: it may have been a bubble. Below, in m: so shallow.
static const double kBubbleSecs = 600;
static const double kEchoShallowM = 12;
/// m/s; a bottom may rise so fast below a vehicle even if it has not done so yet: a slope of one in
/// six.
static const double kRiseMps = 0.05;
static const double kEchoSteeper = 1.5;
static const double kMostRiseMps = 0.3;
/// s; between echoes that are compared.
static const double kAnchorSecs = 60;
static const double kAnchorLastsSecs = 300;
/// This many times the usual gap without an echo: then it is sure that no bottom is within range.
/// One gap in 20,000 is longer, if echoes come at random.
static const double kSure = 10;
// Weight of the newest gap, if it is longer and if it is shorter: some short ones in a row may come
// by chance, and silence must not show deep water sooner for that.
static const double kLongerShare = 0.25, kShorterShare = 0.1;
static const double kMostGap = 40;
/// Cycles; an altimeter with shorter gaps receives an echo in most of them.
static const double kDenseGap = 4;
/// Shares of its range: nearer than this an echo is sure to be received; an echo from nearer than
/// this is not followed by silence.
static const double kSureShare = 0.9;
static const double kWithinShare = 0.6;
static const double kFailedCycles = 10;
/// Echoes; so many are those of a bottom. Fewer may be those of fish.
static const double kMany = 30;
/// m; a vehicle that is so much deeper has sunk.
static const double kEchoSinksM = 0.5;
/// m; above this depth the altimeter is not used.
static const double kListensM = 3;
/// The floor falls to this share of the last echo's depth at most.
static const double kLeastShare = 0.5;
/// m/s; an old echo is approached again this slowly, and only while the altimeter is used: at the
/// surface the floor sinks no deeper than a vehicle needs to use it.
static const double kEasesMps = 0.05;

void hookEchoFloorInit(HookEchoFloor* echoes) {
  echoes->heard = echoes->sank = false;
  echoes->seen_m = echoes->altitude_m = echoes->bottom_m = echoes->heard_at_m = hookUnknown();
  echoes->silent_s = echoes->anchor_m = echoes->anchor_s = hookUnknown();
  echoes->floor_m = echoes->cleared_m = kHookBottomless;
  echoes->echoes = echoes->missed = echoes->listened = echoes->least_m = 0;
  echoes->gap = 20;
  echoes->reach_m = 20;
  echoes->rise_mps = 0.06;
}

void hookEchoFloorIgnore(HookEchoFloor* echoes, double altitude_m) {
  echoes->seen_m = altitude_m;
}

static void learnRise(HookEchoFloor* echoes, double bottom_m) {
  if (echoes->anchor_s < kAnchorSecs) {
    return;
  }
  if (echoes->anchor_s <= kAnchorLastsSecs) {
    const double rise =
        hookBetween((echoes->anchor_m - bottom_m) / echoes->anchor_s, 0, kMostRiseMps);
    echoes->rise_mps = hookAtLeast(rise, (echoes->rise_mps + rise) / 2);
  }
  echoes->anchor_m = bottom_m;
  echoes->anchor_s = 0;
}

static void hearEcho(HookEchoFloor* echoes, double depth_m, double altitude_m) {
  echoes->altitude_m = altitude_m;
  echoes->bottom_m = echoes->floor_m = depth_m + altitude_m;
  echoes->reach_m = hookAtLeast(altitude_m, echoes->reach_m);
  // A gap over a bottom out of range says nothing about the altimeter, unless the bottom is one
  // that silence seemed to have ruled out.
  if (!(echoes->bottom_m >= echoes->cleared_m)) {
    const double gap = hookAtMost(echoes->missed + 1, kMostGap);
    echoes->gap += (gap - echoes->gap) * (gap > echoes->gap ? kLongerShare : kShorterShare);
  }
  echoes->missed = echoes->listened = 0;
  echoes->echoes += 1;
  echoes->cleared_m = kHookBottomless;
  echoes->heard_at_m = depth_m;
  echoes->silent_s = 0;
  learnRise(echoes, echoes->bottom_m);
}

/// A bottom above this depth would have returned an echo, m.
static double beyondRange(const HookEchoFloor* echoes, double depth_m) {
  return depth_m + kSureShare * echoes->reach_m;
}

/// Silence for many times the usual gap shows that no bottom is within range of the least depth of
/// that time.
static void listenFrom(HookEchoFloor* echoes, double depth_m) {
  echoes->least_m = echoes->listened == 0 ? depth_m : hookAtMost(depth_m, echoes->least_m);
  echoes->listened += 1;
  if (echoes->listened >= kSure * echoes->gap && !hookEchoFloorHasFailed(echoes)) {
    echoes->cleared_m = beyondRange(echoes, echoes->least_m);
    echoes->floor_m = hookAtLeast(echoes->floor_m, echoes->cleared_m);
    echoes->listened = echoes->echoes = 0;
  }
}

static void waitForEcho(HookEchoFloor* echoes, double depth_m, double least_m, double step_s) {
  if (!(echoes->floor_m < kHookBottomless)) {
    return;
  }
  const bool listens = depth_m > kListensM;
  if (listens && echoes->bottom_m <= beyondRange(echoes, depth_m)) {
    echoes->missed += 1;
  }
  if (echoes->silent_s <= kFreshSecs) {
    echoes->sank = depth_m > echoes->heard_at_m + kEchoSinksM;
    return;
  }
  if (echoes->silent_s > kLastsSecs) {
    echoes->floor_m += listens || echoes->floor_m < least_m ? kEasesMps * step_s : 0;
  } else if (listens) {
    echoes->floor_m -= (kRiseMps + kEchoSteeper * echoes->rise_mps) * step_s;
  }
  echoes->floor_m = hookAtLeast(echoes->floor_m, kLeastShare * echoes->bottom_m);
  if (listens) {
    listenFrom(echoes, depth_m);
  }
  if (echoes->silent_s > kBubbleSecs && echoes->bottom_m <= kEchoShallowM) {
    echoes->floor_m = kHookBottomless;
  }
}

void hookEchoFloorObserve(HookEchoFloor* echoes, double depth_m, double altitude_m, double least_m,
                          double step_s) {
  echoes->silent_s += step_s;
  echoes->anchor_s += step_s;
  // The sensor array keeps an old altitude while the altimeter receives no echo, so only a changed
  // altitude is an echo. Between echoes the clearance follows from the depth, which also catches an
  // altimeter that is stuck.
  const bool is_new = altitude_m >= 0 && hookIsFinite(altitude_m) && altitude_m != echoes->seen_m;
  echoes->seen_m = is_new ? altitude_m : echoes->seen_m;
  echoes->heard = is_new && hookIsFinite(depth_m);
  if (echoes->heard) {
    hearEcho(echoes, depth_m, altitude_m);
  } else if (hookIsFinite(depth_m)) {
    waitForEcho(echoes, depth_m, least_m, step_s);
  }
}

bool hookEchoFloorHasFailed(const HookEchoFloor* echoes) {
  const bool within = echoes->sank || echoes->altitude_m < kWithinShare * echoes->reach_m;
  return echoes->gap < kDenseGap && echoes->echoes >= kMany && within &&
         echoes->missed >= kFailedCycles;
}
