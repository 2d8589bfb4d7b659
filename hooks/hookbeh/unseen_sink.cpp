// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/hookbeh/unseen_sink.h"

#include "hooks/protocol/numbers.h"

namespace glider::hooks {
namespace {

/// m; a depth that flickers without being rough moves less than this.
constexpr double kMovesM = 2.5;
/// m; from one time that a dive shows itself to the next, it goes on by at least this.
constexpr double kFurtherM = 1;
/// m; an answer to a climb is at least this far: a stuck depth that wavers slowly rises less.
constexpr double kAnswersM = 5;
/// m; in a rougher depth the distance alone shows nothing: waves and broken sensors reach it too.
constexpr double kRoughM = 0.3;
constexpr double kRoughShare = 1.0 / 8;  // weight of the newest reading
/// In a rough depth this many times the roughness is added to the distance; in one rougher than
/// kWildM, in m, no distance counts.
constexpr double kRoughTimes = 6;
constexpr double kWildM = 1.5;
/// m; what noise adds to the motion between two readings; and what swell adds, in roughnesses.
constexpr double kNoiseM = 0.5;
constexpr double kSwellTimes = 2;
/// s; after a longer gap, and after more than twice the usual one, the depth may be a different
/// one.
constexpr double kSinkGapSecs = 20;
/// m; what a vehicle sinks in calm water before its depth shows it, and how much more in swell of
/// half a metre or more, whose roughness in m follows.
constexpr double kCalmM = 7;
constexpr double kSwellM = 3;
constexpr double kSwellRoughM = 0.6;
constexpr double kCalmRoughM = 0.1;  // the sensor's own noise
/// s between readings: the usual cycle; above it, up to the second, all of this grows by the third.
constexpr double kUsualSecs = 4;
constexpr double kRarestSecs = 16;
constexpr double kRareSecs = 18;
/// m; at the surface, where a climb ends, this much is an answer.
constexpr double kSinkAtSurfaceM = 1;
constexpr double kSurfacesM = 1;
/// Share of the stroke, cc and rad; from kLiftsShare (the weakest climb that a b_arg allows) and
/// kNoseRad on the vehicle is driven up, from kSinksCc or a pitch of -kNoseRad on it is driven
/// down.
constexpr double kLiftsShare = 0.5;
constexpr double kSinksCc = -60;
constexpr double kNoseRad = 0.1;
/// s; the time that the pump takes from one end to the other and the vehicle takes to turn.
constexpr double kSinkTurnsSecs = 20;
/// s; a vehicle driven up may rise after this time, and one driven down may still rise for as long.
constexpr double kLiftsSecs = 12;
/// s; a pump that was driven out for longer than this must first come back in before the vehicle
/// sinks again.
constexpr double kBackSecs = 4;
/// Readings; a vehicle that is driven another way leaves the line of this many.
constexpr uint8_t kTurningReadings = 3;
/// rad; at a flatter pitch the vehicle is assumed to sink as at this one.
constexpr double kFlatRad = 0.3;
/// The fastest vertical rate of the hull is the usual one: a heavy vehicle sinks faster.
constexpr double kMargin = 1.1;
/// m/s; the fastest that a vehicle that is driven neither up nor down sinks in water that it is not
/// trimmed for.
constexpr double kAdriftMps = 0.1;
/// m/s; the slowest that a vehicle that is driven up climbs.
constexpr double kClimbMps = 0.1;

/// m; so far a depth of this roughness must go.
double farEnough(double roughness_m) {
  return roughness_m <= kRoughM  ? kMovesM
         : roughness_m <= kWildM ? kMovesM + kRoughTimes * roughness_m
                                 : __builtin_nan("");
}

}  // namespace

double UnseenSink::steepestRate() const {
  return kMargin * hull_.vertical_rate_m_s;
}

double UnseenSink::rateAt(double pitch_rad) const {
  return steepestRate() * atLeast(magnitude(pitch_rad), kFlatRad) / hull_.steepest_pitch_rad;
}

double UnseenSink::lateBy() const {
  const double rough = (roughness_m_ - kCalmRoughM) / (kSwellRoughM - kCalmRoughM);
  const double swell_m = kSwellM * between(rough, 0, 1);
  const double rare = (between(cadence_.usual(), kUsualSecs, kRarestSecs) - kUsualSecs) / kRareSecs;
  return (kCalmM + swell_m) * (1 + rare) - kCalmM;
}

void UnseenSink::observe(double depth_m, double step_s, const VerticalCommand& last) {
  if (isFinite(last.pump_cc)) {
    reckon(step_s, last);
    masked_s_ = 0;
  } else {
    turn(false, false);
    masked_s_ += step_s;
    sinks_ =
        sinks_ && masked_s_ <= kSinkTurnsSecs;  // later it may be brought up, as its depth shows
    out_s_ = in_dive_m_ = steeply_m_ = 0;
  }
  // The sensor array keeps a reading until there is a newer one. Only a new one shows anything.
  cadence_.observe(depth_m, step_s);
  if (cadence_.isNew()) {
    follow(depth_m);
    seek(depth_m);
  }
}

void UnseenSink::reckon(double step_s, const VerticalCommand& last) {
  const bool lifts = last.pump_cc >= kLiftsShare * hull_.pump_cc && last.pitch_rad >= kNoseRad;
  const bool dives = last.pitch_rad <= -kNoseRad;
  if (lifts_ && !lifts) {
    since_up_s_ = atMost(since_up_s_, kLiftsSecs - between(out_s_ - kBackSecs, 0, kLiftsSecs));
  }
  turn(lifts, dives);
  out_s_ = lifts ? out_s_ + step_s : 0;
  const bool rises = out_s_ > kSinkTurnsSecs;
  sinks_ = !rises && (lifts || last.pump_cc <= kSinksCc || dives);
  since_up_s_ = rises ? 0 : since_up_s_ + step_s;
  if (rises) {
    deepest_m_ = atLeast(deepest_m_ - kClimbMps * step_s, 0);
    reckonUnanswered(0, kClimbMps * step_s);
    in_dive_m_ = steeply_m_ = 0;
  } else if (since_up_s_ > kLiftsSecs) {
    // A battery at a fixed place may hold the nose down, and a hull that is not level sinks faster.
    const bool level = !sinks_ && last.pitch_mode != PitchMode::Battery;
    const double sunk_m = (level ? kAdriftMps : rateAt(last.pitch_rad)) * step_s;
    deepest_m_ += sunk_m;
    reckonUnanswered(sunk_m, 0);
    in_dive_m_ += dives ? rateAt(last.pitch_rad) * step_s : 0;
    steeply_m_ += dives ? steepestRate() * step_s : 0;
  }
}

void UnseenSink::reckonUnanswered(double sunk_m, double risen_m) {
  alone_m_ += sunk_m - risen_m;
  unanswered_m_ += sunk_m;
  if (risen_m > 0 && alone_m_ <= 0) {  // it must be at the surface
    alone_m_ = answered_m_ = unanswered_m_ = 0;
  }
}

/// The vehicle is driven another way: what its depth did before is not an answer to that.
void UnseenSink::turn(bool lifts, bool dives) {
  if (lifts != lifts_ || dives != dives_) {
    turning_ = kTurningReadings;
    turned_m_ = __builtin_nan("");
    dived_m_ = __builtin_nan("");
    trend_.clear();
  }
  lifts_ = lifts;
  dives_ = dives;
}

/// Measures how smoothly the depth changes, in real time: by how far the reading before was off the
/// line between its neighbours. A turn is not rough.
void UnseenSink::follow(double depth_m) {
  const double moved = depth_m - last_m_;
  const double gap = cadence_.gap();
  const double off = magnitude(moved_m_ * gap - moved * gap_s_) / (gap_s_ + gap);
  if (turning_ > 0) {
    turning_ -= 1;
  } else if (isFinite(off)) {  // there were two before
    roughness_m_ += (off - roughness_m_) * kRoughShare;
  }
  moved_m_ = moved;
  gap_s_ = gap;
}

void UnseenSink::restartAt(double depth_m) {
  highest_m_ = lowest_m_ = depth_m;
  trend_.clear();
}

/// Checks whether the depth has moved: down if the vehicle is driven down, up if it is driven up,
/// else either way.
void UnseenSink::seek(double depth_m) {
  // After a step that no vehicle can make, or a long gap in the depth, the search starts again.
  const double reach = steepestRate() * gap_s_ + kNoiseM + kSwellTimes * roughness_m_;
  const bool steps = magnitude(depth_m - last_m_) > reach;
  if (!isFinite(shown_m_)) {
    shown_m_ = deepest_m_ = alone_m_ = answered_m_ = depth_m;
    unanswered_m_ = 0;
    restartAt(depth_m);
  } else if (steps || gap_s_ > atLeast(2 * cadence_.usual(), kSinkGapSecs)) {
    restartAt(depth_m);
    turned_m_ = __builtin_nan("");
  }
  highest_m_ = atMost(depth_m, highest_m_);
  lowest_m_ = atLeast(depth_m, lowest_m_);
  turned_m_ = lifts_ ? atLeast(turned_m_, depth_m) : atMost(turned_m_, depth_m);
  trend_.add(depth_m, gap_s_);
  last_m_ = depth_m;
  const double trend_m = roughness_m_ > kRoughM ? trend_.moved(roughness_m_, steepestRate()) : 0;
  const bool lifts = out_s_ >= kLiftsSecs;
  // A dive goes on. A stuck depth that wavers comes back to where it was.
  const bool further = !dives_ || !(depth_m < dived_m_ + kFurtherM);
  const bool down = hasMovedDown(depth_m, trend_m) && out_s_ == 0 && further;
  const bool up = hasMovedUp(depth_m, trend_m) && (lifts || !sinks_);
  if (hasAnswered(depth_m, trend_m)) {
    alone_m_ = answered_m_ = depth_m;
    unanswered_m_ = 0;
  }
  if (down || up) {
    dived_m_ = dives_ && down ? depth_m : dived_m_;
    show(depth_m);
  }
}

bool UnseenSink::hasMovedDown(double depth_m, double trend_m) const {
  return depth_m - highest_m_ >= farEnough(roughness_m_) || trend_m > 0;
}

bool UnseenSink::hasMovedUp(double depth_m, double trend_m) const {
  return lowest_m_ - depth_m >= farEnough(roughness_m_) || trend_m < 0;
}

/// Only what the depth did since the vehicle was driven this way by its pitch is an answer.
bool UnseenSink::hasAnswered(double depth_m, double trend_m) const {
  if (dives_) {
    return depth_m - turned_m_ >= farEnough(roughness_m_) || trend_m > 0;
  }
  const double rose_m = turned_m_ - depth_m;
  const bool surfaced =
      depth_m <= kSinkAtSurfaceM && rose_m >= kSurfacesM && roughness_m_ <= kRoughM;
  const bool rose = rose_m >= atLeast(kAnswersM, farEnough(roughness_m_)) || trend_m < -kAnswersM;
  return out_s_ >= kLiftsSecs && (rose || surfaced);
}

void UnseenSink::show(double depth_m) {
  shown_m_ = deepest_m_ = depth_m;
  restartAt(depth_m);
  in_dive_m_ = steeply_m_ = 0;
  has_moved_ = true;
}

void UnseenSink::confirm(double depth_m) {
  steeply_m_ = 0;
  shown_m_ = deepest_m_ = depth_m;
}

}  // namespace glider::hooks
