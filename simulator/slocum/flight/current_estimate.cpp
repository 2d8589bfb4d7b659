// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/slocum/flight/current_estimate.h"

namespace glider::simulator {
namespace {

/// s; after a shorter dive the noise of the fixes would be most of the estimate.
constexpr double kShortestDive = 120;
/// s between the two fixes: the default of surface's gps_postfix_wait_time.
constexpr double kPostfix = 60;

}  // namespace

void CurrentEstimate::dive(double time_s) {
  // A surfacing without a fix does not end the reckoning.
  if (state_ != State::AwaitingFix) {
    dived_s_ = time_s;
  }
  state_ = State::UnderWater;
}

void CurrentEstimate::surface(double time_s, Planar reckoned) {
  surfaced_s_ = time_s;
  reckoned_ = reckoned;
  state_ = State::AwaitingFix;
}

void CurrentEstimate::estimate(Planar surfaced_at) {
  const double under_s = surfaced_s_ - dived_s_;
  if (under_s >= kShortestDive) {
    current_ = {used_.east + (surfaced_at.east - reckoned_.east) / under_s,
                used_.north + (surfaced_at.north - reckoned_.north) / under_s};
  }
}

void CurrentEstimate::observe(double time_s, bool at_surface, Planar reckoned,
                              std::optional<Planar> fix, Planar used) {
  if (!at_surface) {
    if (state_ != State::UnderWater) {
      dive(time_s);
    }
    used_ = used;
    return;
  }
  if (state_ == State::UnderWater) {
    surface(time_s, reckoned);
  }
  if (!fix) {
    return;
  }
  if (state_ == State::AwaitingFix) {
    fixed_s_ = time_s;
    fixed_at_ = *fix;
    estimate(*fix);
    state_ = State::AwaitingPostfix;
  } else if (state_ == State::AwaitingPostfix && time_s - fixed_s_ >= kPostfix) {
    const double drifted = (fixed_s_ - surfaced_s_) / (time_s - fixed_s_);
    estimate({fixed_at_.east - (fix->east - fixed_at_.east) * drifted,
              fixed_at_.north - (fix->north - fixed_at_.north) * drifted});
    state_ = State::AwaitingDive;
  }
}

}  // namespace glider::simulator
