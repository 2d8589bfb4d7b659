// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/hookbeh/unseen_sink.h"

#include "hooks/protocol/numbers.h"

/// m; a depth that flickers without being rough moves less than this.
static const double kMovesM = 2.5;
/// m; from one time that a dive shows itself to the next, it goes on by at least this.
static const double kFurtherM = 1;
/// m; an answer to a climb is at least this far: a stuck depth that wavers slowly rises less.
static const double kAnswersM = 5;
/// m; in a rougher depth the distance alone shows nothing: waves and broken sensors reach it too.
static const double kRoughM = 0.3;
static const double kRoughShare = 1.0 / 8;  // weight of the newest reading
/// In a rough depth this many times the roughness is added to the distance; in one rougher than
/// kWildM, in m, no distance counts.
static const double kRoughTimes = 6;
static const double kWildM = 1.5;
/// m; what noise adds to the motion between two readings; and what swell adds, in roughnesses.
static const double kNoiseM = 0.5;
static const double kSwellTimes = 2;
/// s; after a longer gap, and after more than twice the usual one, the depth may be a different
/// one.
static const double kSinkGapSecs = 20;
/// m; what a vehicle sinks in calm water before its depth shows it, and how much more in swell of
/// half a metre or more, whose roughness in m follows.
static const double kCalmM = 7;
static const double kSwellM = 3;
static const double kSwellRoughM = 0.6;
static const double kCalmRoughM = 0.1;  // the sensor's own noise
/// s between readings: the usual cycle; above it, up to the second, all of this grows by the third.
static const double kUsualSecs = 4;
static const double kRarestSecs = 16;
static const double kRareSecs = 18;
/// m; at the surface, where a climb ends, this much is an answer.
static const double kSinkAtSurfaceM = 1;
static const double kSurfacesM = 1;
/// Share of the stroke, cc and rad; from kLiftsShare (the weakest climb that a b_arg allows) and
/// kNoseRad on the vehicle is driven up, from kSinksCc or a pitch of -kNoseRad on it is driven
/// down.
static const double kLiftsShare = 0.5;
static const double kSinksCc = -60;
static const double kNoseRad = 0.1;
/// s; the time that the pump takes from one end to the other and the vehicle takes to turn.
static const double kSinkTurnsSecs = 20;
/// s; a vehicle driven up may rise after this time, and one driven down may still rise for as long.
static const double kLiftsSecs = 12;
/// s; a pump that was driven out for longer than this must first come back in before the vehicle
/// sinks again.
static const double kBackSecs = 4;
/// Readings; a vehicle that is driven another way leaves the line of this many.
enum { kTurningReadings = 3 };
/// rad; at a flatter pitch the vehicle is assumed to sink as at this one.
static const double kFlatRad = 0.3;
/// The fastest vertical rate of the hull is the usual one: a heavy vehicle sinks faster.
static const double kMargin = 1.1;
/// m/s; the fastest that a vehicle that is driven neither up nor down sinks in water that it is not
/// trimmed for.
static const double kAdriftMps = 0.1;
/// m/s; the slowest that a vehicle that is driven up climbs.
static const double kClimbMps = 0.1;

void hookUnseenSinkInit(HookUnseenSink* sink, const HookHull* hull) {
  sink->hull = *hull;
  hookCadenceInit(&sink->cadence);
  hookTrendInit(&sink->trend);
  sink->deepest_m = sink->shown_m = sink->highest_m = sink->lowest_m = hookUnknown();
  sink->last_m = sink->moved_m = sink->gap_s = hookUnknown();
  sink->turned_m = sink->dived_m = sink->alone_m = hookUnknown();
  sink->has_moved = sink->sinks = sink->lifts = sink->dives = false;
  sink->in_dive_m = sink->steeply_m = sink->out_s = sink->masked_s = sink->since_up_s = 0;
  sink->roughness_m = sink->answered_m = sink->unanswered_m = 0;
  sink->turning = 0;
}

double hookUnseenSinkLateBy(const HookUnseenSink* sink) {
  const double rough = (sink->roughness_m - kCalmRoughM) / (kSwellRoughM - kCalmRoughM);
  const double swell_m = kSwellM * hookBetween(rough, 0, 1);
  const double rare =
      (hookBetween(sink->cadence.usual_s, kUsualSecs, kRarestSecs) - kUsualSecs) / kRareSecs;
  return (kCalmM + swell_m) * (1 + rare) - kCalmM;
}

/// The vehicle is driven another way: what its depth did before is not an answer to that.
static void turnTo(HookUnseenSink* sink, bool lifts, bool dives) {
  if (lifts != sink->lifts || dives != sink->dives) {
    sink->turning = kTurningReadings;
    sink->turned_m = hookUnknown();
    sink->dived_m = hookUnknown();
    hookTrendClear(&sink->trend);
  }
  sink->lifts = lifts;
  sink->dives = dives;
}

static void reckonUnanswered(HookUnseenSink* sink, double sunk_m, double risen_m) {
  sink->alone_m += sunk_m - risen_m;
  sink->unanswered_m += sunk_m;
  if (risen_m > 0 && sink->alone_m <= 0) {  // it must be at the surface
    sink->alone_m = sink->answered_m = sink->unanswered_m = 0;
  }
}

/// The fastest the vehicle sinks, m/s: at its steepest pitch, or at this one.
static double steepestRate(const HookUnseenSink* sink) {
  return kMargin * sink->hull.vertical_rate_m_s;
}

static double rateAtPitch(const HookUnseenSink* sink, double pitch_rad) {
  return steepestRate(sink) * hookAtLeast(hookMagnitude(pitch_rad), kFlatRad) /
         sink->hull.steepest_pitch_rad;
}

static void reckon(HookUnseenSink* sink, double step_s, const HookVerticalCommand* last) {
  const bool lifts =
      last->pump_cc >= kLiftsShare * sink->hull.pump_cc && last->pitch_rad >= kNoseRad;
  const bool dives = last->pitch_rad <= -kNoseRad;
  if (sink->lifts && !lifts) {
    sink->since_up_s = hookAtMost(sink->since_up_s,
                                  kLiftsSecs - hookBetween(sink->out_s - kBackSecs, 0, kLiftsSecs));
  }
  turnTo(sink, lifts, dives);
  sink->out_s = lifts ? sink->out_s + step_s : 0;
  const bool rises = sink->out_s > kSinkTurnsSecs;
  sink->sinks = !rises && (lifts || last->pump_cc <= kSinksCc || dives);
  sink->since_up_s = rises ? 0 : sink->since_up_s + step_s;
  if (rises) {
    sink->deepest_m = hookAtLeast(sink->deepest_m - kClimbMps * step_s, 0);
    reckonUnanswered(sink, 0, kClimbMps * step_s);
    sink->in_dive_m = sink->steeply_m = 0;
  } else if (sink->since_up_s > kLiftsSecs) {
    // A battery at a fixed place may hold the nose down, and a hull that is not level sinks faster.
    const bool level = !sink->sinks && last->pitch_mode != kHookPitchModeBattery;
    const double sunk_m = (level ? kAdriftMps : rateAtPitch(sink, last->pitch_rad)) * step_s;
    sink->deepest_m += sunk_m;
    reckonUnanswered(sink, sunk_m, 0);
    sink->in_dive_m += dives ? rateAtPitch(sink, last->pitch_rad) * step_s : 0;
    sink->steeply_m += dives ? steepestRate(sink) * step_s : 0;
  }
}

/// Measures how smoothly the depth changes, in real time: by how far the reading before was off the
/// line between its neighbours. A turn is not rough.
static void followMotion(HookUnseenSink* sink, double depth_m) {
  const double moved = depth_m - sink->last_m;
  const double gap = sink->cadence.since_s;
  const double off = hookMagnitude(sink->moved_m * gap - moved * sink->gap_s) / (sink->gap_s + gap);
  if (sink->turning > 0) {
    --sink->turning;
  } else if (hookIsFinite(off)) {  // there were two before
    sink->roughness_m += (off - sink->roughness_m) * kRoughShare;
  }
  sink->moved_m = moved;
  sink->gap_s = gap;
}

static void restartAt(HookUnseenSink* sink, double depth_m) {
  sink->highest_m = sink->lowest_m = depth_m;
  hookTrendClear(&sink->trend);
}

/// m; so far a depth of this roughness must go.
static double farEnough(double roughness_m) {
  return roughness_m <= kRoughM  ? kMovesM
         : roughness_m <= kWildM ? kMovesM + kRoughTimes * roughness_m
                                 : hookUnknown();
}

static bool hasMovedDown(const HookUnseenSink* sink, double depth_m, double trend_m) {
  return depth_m - sink->highest_m >= farEnough(sink->roughness_m) || trend_m > 0;
}

static bool hasMovedUp(const HookUnseenSink* sink, double depth_m, double trend_m) {
  return sink->lowest_m - depth_m >= farEnough(sink->roughness_m) || trend_m < 0;
}

/// Only what the depth did since the vehicle was driven this way by its pitch is an answer.
static bool hasAnswered(const HookUnseenSink* sink, double depth_m, double trend_m) {
  if (sink->dives) {
    return depth_m - sink->turned_m >= farEnough(sink->roughness_m) || trend_m > 0;
  }
  const double rose_m = sink->turned_m - depth_m;
  const bool surfaced =
      depth_m <= kSinkAtSurfaceM && rose_m >= kSurfacesM && sink->roughness_m <= kRoughM;
  const bool rose =
      rose_m >= hookAtLeast(kAnswersM, farEnough(sink->roughness_m)) || trend_m < -kAnswersM;
  return sink->out_s >= kLiftsSecs && (rose || surfaced);
}

static void showAt(HookUnseenSink* sink, double depth_m) {
  sink->shown_m = sink->deepest_m = depth_m;
  restartAt(sink, depth_m);
  sink->in_dive_m = sink->steeply_m = 0;
  sink->has_moved = true;
}

/// Checks whether the depth has moved: down if the vehicle is driven down, up if it is driven up,
/// else either way.
static void seekMotion(HookUnseenSink* sink, double depth_m) {
  // After a step that no vehicle can make, or a long gap in the depth, the search starts again.
  const double reach = steepestRate(sink) * sink->gap_s + kNoiseM + kSwellTimes * sink->roughness_m;
  const bool steps = hookMagnitude(depth_m - sink->last_m) > reach;
  if (!hookIsFinite(sink->shown_m)) {
    sink->shown_m = sink->deepest_m = sink->alone_m = sink->answered_m = depth_m;
    sink->unanswered_m = 0;
    restartAt(sink, depth_m);
  } else if (steps || sink->gap_s > hookAtLeast(2 * sink->cadence.usual_s, kSinkGapSecs)) {
    restartAt(sink, depth_m);
    sink->turned_m = hookUnknown();
  }
  sink->highest_m = hookAtMost(depth_m, sink->highest_m);
  sink->lowest_m = hookAtLeast(depth_m, sink->lowest_m);
  sink->turned_m =
      sink->lifts ? hookAtLeast(sink->turned_m, depth_m) : hookAtMost(sink->turned_m, depth_m);
  hookTrendAdd(&sink->trend, depth_m, sink->gap_s);
  sink->last_m = depth_m;
  const double trend_m = sink->roughness_m > kRoughM
                             ? hookTrendMoved(&sink->trend, sink->roughness_m, steepestRate(sink))
                             : 0;
  const bool lifts = sink->out_s >= kLiftsSecs;
  // A dive goes on. A stuck depth that wavers comes back to where it was.
  const bool further = !sink->dives || !(depth_m < sink->dived_m + kFurtherM);
  const bool down = hasMovedDown(sink, depth_m, trend_m) && sink->out_s == 0 && further;
  const bool up = hasMovedUp(sink, depth_m, trend_m) && (lifts || !sink->sinks);
  if (hasAnswered(sink, depth_m, trend_m)) {
    sink->alone_m = sink->answered_m = depth_m;
    sink->unanswered_m = 0;
  }
  if (down || up) {
    sink->dived_m = sink->dives && down ? depth_m : sink->dived_m;
    showAt(sink, depth_m);
  }
}

void hookUnseenSinkObserve(HookUnseenSink* sink, double depth_m, double step_s,
                           const HookVerticalCommand* last) {
  if (hookIsFinite(last->pump_cc)) {
    reckon(sink, step_s, last);
    sink->masked_s = 0;
  } else {
    turnTo(sink, false, false);
    sink->masked_s += step_s;
    sink->sinks =
        sink->sinks &&
        sink->masked_s <= kSinkTurnsSecs;  // later it may be brought up, as its depth shows
    sink->out_s = sink->in_dive_m = sink->steeply_m = 0;
  }
  // The sensor array keeps a reading until there is a newer one. Only a new one shows anything.
  hookCadenceObserve(&sink->cadence, depth_m, step_s);
  if (sink->cadence.is_new) {
    followMotion(sink, depth_m);
    seekMotion(sink, depth_m);
  }
}

void hookUnseenSinkConfirm(HookUnseenSink* sink, double depth_m) {
  sink->steeply_m = 0;
  sink->shown_m = sink->deepest_m = depth_m;
}
