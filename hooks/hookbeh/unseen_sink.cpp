// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/hookbeh/unseen_sink.h"

#include "hooks/protocol/numbers.h"

namespace glider::hooks {
namespace {

/// m; a depth that flickers without being rough moves less than this.
constexpr double kMovesM = 2.5;
/// m; a depth rougher than this shows nothing. Waves at the surface and broken sensors cause such
/// roughness.
constexpr double kRoughM = 0.6;
constexpr double kRoughShare = 1.0 / 8;  // weight of the newest cycle
/// m; what noise adds to the motion of one cycle.
constexpr double kNoiseM = 0.5;
/// s; after a longer gap the depth may be a different one.
constexpr double kGapSecs = 20;
/// cc and rad; from kLiftsCc and kNoseRad on the vehicle is driven up, from kSinksCc or a pitch of
/// -kNoseRad on it is driven down.
constexpr double kLiftsCc = 150;
constexpr double kSinksCc = -60;
constexpr double kNoseRad = 0.1;
/// s; the time that the pump takes from one end to the other and the vehicle takes to turn.
constexpr double kTurnsSecs = 20;
/// s; a vehicle driven up may rise after this time, and one driven down may still rise for as long.
constexpr double kLiftsSecs = 12;
/// rad; at a flatter pitch the vehicle is assumed to sink as at this one.
constexpr double kFlatRad = 0.3;
/// The fastest vertical rate of the hull is the usual one: a heavy vehicle sinks faster.
constexpr double kMargin = 1.1;
/// m/s; the fastest that a vehicle that is driven neither up nor down sinks in water that it is not
/// trimmed for.
constexpr double kAdriftMps = 0.1;
/// m/s; the slowest that a vehicle that is driven up climbs.
constexpr double kClimbMps = 0.1;

}  // namespace

double UnseenSink::steepestRate() const {
  return kMargin * hull_.vertical_rate_m_s;
}

double UnseenSink::rateAt(double pitch_rad) const {
  return steepestRate() * atLeast(magnitude(pitch_rad), kFlatRad) / hull_.steepest_pitch_rad;
}

void UnseenSink::observe(double depth_m, double step_s, const VerticalCommand& last) {
  if (isFinite(last.pump_cc)) {
    reckon(step_s, last);
  } else {
    out_s_ = in_dive_m_ = steeply_m_ = 0;
  }
  gap_s_ += step_s;
  if (isFinite(depth_m)) {
    follow(depth_m, step_s);
    seek(depth_m);
  }
}

void UnseenSink::reckon(double step_s, const VerticalCommand& last) {
  const bool lifts = last.pump_cc >= kLiftsCc && last.pitch_rad >= kNoseRad;
  out_s_ = lifts ? out_s_ + step_s : 0;
  const bool rises = out_s_ > kTurnsSecs;
  sinks_ = !rises && (lifts || last.pump_cc <= kSinksCc || last.pitch_rad <= -kNoseRad);
  since_up_s_ = rises ? 0 : since_up_s_ + step_s;
  if (rises) {
    deepest_m_ = atLeast(deepest_m_ - kClimbMps * step_s, 0);
    in_dive_m_ = steeply_m_ = 0;
  } else if (since_up_s_ > kLiftsSecs) {
    deepest_m_ += (sinks_ ? rateAt(last.pitch_rad) : kAdriftMps) * step_s;
    const bool dives = last.pitch_rad <= -kNoseRad;
    in_dive_m_ += dives ? rateAt(last.pitch_rad) * step_s : 0;
    steeply_m_ += dives ? steepestRate() * step_s : 0;
  }
}

/// Measures how smoothly the depth changes.
void UnseenSink::follow(double depth_m, double step_s) {
  const double moved = depth_m - last_m_;
  const bool goes_on = gap_s_ <= step_s;  // not the first, nor one after a gap
  if (goes_on) {
    roughness_m_ += (magnitude(moved - moved_m_) - roughness_m_) * kRoughShare;
  }
  moved_m_ = goes_on ? moved : 0;
}

/// Checks whether the depth has moved: down if the vehicle is driven down, up if it is driven up,
/// else either way.
void UnseenSink::seek(double depth_m) {
  // After a step that no vehicle can make, or a long gap in the depth, the search starts again.
  const bool steps = magnitude(depth_m - last_m_) > steepestRate() * gap_s_ + kNoiseM;
  if (!isFinite(shown_m_)) {
    shown_m_ = deepest_m_ = highest_m_ = lowest_m_ = depth_m;
  } else if (steps || gap_s_ > kGapSecs) {
    highest_m_ = lowest_m_ = depth_m;
  }
  highest_m_ = depth_m < highest_m_ ? depth_m : highest_m_;
  lowest_m_ = depth_m > lowest_m_ ? depth_m : lowest_m_;
  const bool lifts = out_s_ >= kLiftsSecs;
  const bool down = depth_m - highest_m_ >= kMovesM && out_s_ == 0;
  const bool up = lowest_m_ - depth_m >= kMovesM && (lifts || !sinks_);
  if (roughness_m_ <= kRoughM && (down || up)) {
    show(depth_m);
  }
  last_m_ = depth_m;
  gap_s_ = 0;
}

void UnseenSink::show(double depth_m) {
  shown_m_ = deepest_m_ = highest_m_ = lowest_m_ = depth_m;
  in_dive_m_ = steeply_m_ = 0;
  has_moved_ = true;
}

void UnseenSink::confirm(double depth_m) {
  steeply_m_ = 0;
  shown_m_ = deepest_m_ = depth_m;
}

}  // namespace glider::hooks
