// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/hookbeh/bottom.h"

#include "hooks/protocol/numbers.h"

namespace glider::hooks {
namespace {

/// m; a vehicle stays this much more above a bottom that it has touched: it turns no sooner.
constexpr double kMarginM = 2;
/// m; a dive shorter than this is not one: a guard's least climb, and its clearance.
constexpr double kLeastDiveM = 6;
/// m; a stop was one on the bottom if the vehicle then climbs this far as its depth shows.
constexpr double kClimbsM = 2.5;
/// m; meanwhile the depth does not show that it sinks, nor in swell of a metre, and makes no step.
constexpr double kSinksM = 2.5;
constexpr double kStepM = 1.5;
constexpr double kStepMps = 0.5;
constexpr double kGapSecs = 36;
/// s and m; a stop so long after another one is that of another dive, and in between the depth of a
/// vehicle that climbed has changed by more.
constexpr double kAnotherDiveSecs = 54;
constexpr double kFollowsM = 1;
/// m; at the surface an old echo lets the vehicle dive so far that it can use the altimeter.
constexpr double kTriesM = 10;
/// m; a dive that has risen by so much is over.
constexpr double kTurnedM = 3;
/// s; an echo this recent shows the bottom by itself.
constexpr double kRecentSecs = 60;
/// m; an echo agrees with a contact within this; it is believed again after so many that do, over
/// so great a range of depths: a stuck altimeter agrees at one depth only.
constexpr double kAgreesM = 2.5;
constexpr double kAgreeing = 3;
constexpr double kAgreesOverM = 8;

}  // namespace

void Bottom::move(const Surroundings& now, double least_altitude_m, double step_s) {
  const double shallow_m = atLeast(least_altitude_m + kMarginM + kLeastDiveM, kShallowM);
  memory_.observe({now.latitude_ddmm, now.longitude_ddmm}, shallow_m, step_s);
}

void Bottom::observe(const Surroundings& now, double depth_m, double least_altitude_m,
                     double step_s) {
  depth_m_ = depth_m;
  echoes_.observe(depth_m, now.altitude_m, least_altitude_m + kTriesM, step_s);
  if (echoes_.heard()) {
    judgeEcho(depth_m);
  }
  if (!failed_ && echoes_.hasFailed()) {
    memory_.keepEcho(echoes_.bottom());
    failed_ = true;
  }
}

/// Follows the dives: each one's greatest depth, until the vehicle has turned.
void Bottom::noteTurn(double depth_m) {
  if (sinks_) {
    if (!(depth_m < dive_m_)) {
      dive_m_ = depth_m;
    } else if (dive_m_ - depth_m > kTurnedM) {
      memory_.noteDive(dive_m_);
      sinks_ = false;
      top_m_ = depth_m;
    }
    return;
  }
  top_m_ = atMost(depth_m, top_m_);
  if (depth_m - top_m_ > kTurnedM) {
    dive_m_ = depth_m;
    sinks_ = true;
  }
}

void Bottom::noteStop() {
  const bool again = isFinite(stop_m_) && stop_age_s_ >= kAnotherDiveSecs;
  stuck_m_ = again && stop_far_m_ < kFollowsM ? depth_m_ : stuck_m_;
  stop_age_s_ = again || !isFinite(stop_m_) ? 0 : stop_age_s_;
  stop_m_ = isFinite(stuck_m_) ? __builtin_nan("") : depth_m_;
  stop_last_m_ = depth_m_;
  stop_gap_s_ = stop_far_m_ = 0;
}

void Bottom::follow(double step_s) {
  stop_gap_s_ += step_s;
  stop_age_s_ += step_s;
  if (!isFinite(depth_m_)) {
    return;
  }
  stop_far_m_ = atLeast(magnitude(depth_m_ - stop_m_), stop_far_m_);
  if (magnitude(depth_m_ - stuck_m_) > kClimbsM) {
    stuck_m_ = __builtin_nan("");
  }
  // The sensor array keeps a reading until there is a newer one.
  if (isFinite(stop_m_) && depth_m_ != stop_last_m_) {
    confirm();
  }
  noteTurn(depth_m_);  // afterwards: until then the dive before is the one before the stop
}

void Bottom::confirm() {
  const bool steps = magnitude(depth_m_ - stop_last_m_) > kStepM + kStepMps * stop_gap_s_;
  if (steps || stop_gap_s_ > kGapSecs || depth_m_ > stop_m_ + kSinksM) {
    stop_m_ = __builtin_nan("");
    return;
  }
  stop_last_m_ = depth_m_;
  stop_gap_s_ = 0;
  if (stop_m_ - depth_m_ >= kClimbsM) {
    const bool contradicts =
        !(echoes_.silence() <= kRecentSecs && magnitude(echoes_.bottom() - stop_m_) <= kAgreesM);
    believed_ = believed_ && !contradicts;
    agreed_ = 0;
    memory_.touch(stop_m_);
    stop_m_ = __builtin_nan("");
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
  return memory_.touchedFloor() - kMarginM;
}

double Bottom::floor() const {
  const bool shows = believed_ && echoes_.silence() <= kRecentSecs;
  return shows ? echoes_.floor() : atMost(memory_.floor() - kMarginM, echoes_.floor());
}

}  // namespace glider::hooks
