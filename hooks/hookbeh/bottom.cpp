// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/hookbeh/bottom.h"

#include "hooks/protocol/numbers.h"

namespace glider::hooks {
namespace {

/// m; a vehicle stays this much more above a bottom that it has touched: it turns no sooner.
constexpr double kMarginM = 2;
/// m; a stop was one on the bottom if the vehicle then climbs this far as its depth shows.
constexpr double kClimbsM = 2.5;
/// m; meanwhile the depth does not show that it sinks, and makes no step.
constexpr double kSinksM = 1.5;
constexpr double kStepM = 1.5;
constexpr double kStepMps = 0.5;
constexpr double kGapSecs = 20;
/// m; a dive that has risen by so much is over.
constexpr double kTurnedM = 3;
/// Where the dive before a contact went deeper, the bottom was deeper still: it rises this much more
/// steeply.
constexpr double kDeeper = 2;
/// s; an echo this recent shows the bottom by itself.
constexpr double kRecentSecs = 60;
/// m; an echo agrees with a contact within this; it is believed again after so many that do, over
/// so great a range of depths: a stuck altimeter agrees at one depth only.
constexpr double kAgreesM = 2.5;
constexpr double kAgreeing = 3;
constexpr double kAgreesOverM = 5;

}  // namespace

void Bottom::observe(const Surroundings& now, double depth_m, double step_s) {
  here_ = {now.latitude_ddmm, now.longitude_ddmm};
  depth_m_ = depth_m;
  memory_.observe(here_, step_s);
  echoes_.observe(depth_m, now.altitude_m, step_s);
  stop_gap_s_ += step_s;
  if (isFinite(depth_m)) {
    noteTurn(depth_m);
    followClimb(depth_m, step_s);
  }
  if (echoes_.heard()) {
    judgeEcho(depth_m);
  }
  if (!failed_ && echoes_.hasFailed()) {
    memory_.add(here_, echoes_.bottom(), 0, false);
    failed_ = true;
  }
}

/// Follows the dives: each one's greatest depth, until the vehicle has turned.
void Bottom::noteTurn(double depth_m) {
  if (sinks_) {
    if (!(depth_m < dive_.depth_m)) {
      dive_ = {depth_m, here_};
    } else if (dive_.depth_m - depth_m > kTurnedM) {
      earlier_ = dive_;
      sinks_ = false;
      top_m_ = depth_m;
    }
    return;
  }
  top_m_ = atMost(depth_m, top_m_);
  if (depth_m - top_m_ > kTurnedM) {
    dive_ = {depth_m, here_};
    sinks_ = true;
  }
}

void Bottom::noteStop() {
  stop_ = {depth_m_, here_};
  stop_last_m_ = depth_m_;
  stop_gap_s_ = 0;
}

/// Confirms a stop: a depth sensor that is stuck would not follow the climb.
void Bottom::followClimb(double depth_m, double step_s) {
  if (!isFinite(stop_.depth_m)) {
    return;
  }
  const bool steps = magnitude(depth_m - stop_last_m_) > kStepM + kStepMps * step_s;
  if (steps || stop_gap_s_ > kGapSecs || depth_m > stop_.depth_m + kSinksM) {
    stop_ = {};
    return;
  }
  stop_last_m_ = depth_m;
  stop_gap_s_ = 0;
  if (stop_.depth_m - depth_m >= kClimbsM) {
    const bool contradicts = !(echoes_.silence() <= kRecentSecs &&
                               magnitude(echoes_.bottom() - stop_.depth_m) <= kAgreesM);
    believed_ = believed_ && !contradicts;
    agreed_ = 0;
    const double rise =
        kDeeper * riseBetween(earlier_.at, earlier_.depth_m, stop_.at, stop_.depth_m);
    memory_.add(stop_.at, stop_.depth_m,
                atLeast(rise, memory_.riseTo(stop_.at, stop_.depth_m)), true);
    stop_ = {};
  }
}

/// An altimeter that contradicted a contact is believed again once it agrees with it.
void Bottom::judgeEcho(double depth_m) {
  if (failed_) {
    memory_.forgetEchoes();
    failed_ = false;
  }
  const double touched = memory_.touchedHere();
  if (believed_ || !isFinite(touched)) {
    return;
  }
  if (magnitude(echoes_.bottom() - touched) > kAgreesM) {
    agreed_ = 0;
    return;
  }
  agrees_from_m_ = agreed_ == 0 ? depth_m : atMost(depth_m, agrees_from_m_);
  agrees_to_m_ = agreed_ == 0 ? depth_m : atLeast(depth_m, agrees_to_m_);
  agreed_ += 1;
  believed_ = agreed_ >= kAgreeing && agrees_to_m_ - agrees_from_m_ >= kAgreesOverM;
}

double Bottom::touchedFloor() const {
  return memory_.floor() - kMarginM;
}

double Bottom::floor() const {
  const bool shows = believed_ && echoes_.silence() <= kRecentSecs;
  return shows ? echoes_.floor() : atMost(touchedFloor(), echoes_.floor());
}

}  // namespace glider::hooks
