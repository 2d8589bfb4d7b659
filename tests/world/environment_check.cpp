// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/world/environment_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace glider::tests {
namespace {

/// A double that was a float, and sums of steps, are off by less.
constexpr double kRounding = 1e-6;

}  // namespace

const char* nameOf(Rule rule) {
  switch (rule) {
    case Rule::Rate:
      return "vertical_rate_m_s";
    case Rule::Deepest:
      return "inflection_overshoot_m";
    case Rule::Climb:
      return "slowest_climb_m_s, turn_s";
    case Rule::Above:
      return "never above the surface";
    case Rule::Start:
      return "start_depth_m";
    case Rule::Surface:
      return "surface_depth_m";
    case Rule::Reading:
      return "depth_error_m";
    case Rule::TickGap:
      return "tick_gap_s";
    case Rule::Range:
      return "ranges of sensors";
    case Rule::Drift:
      return "drift_m_s";
    case Rule::ThroughWater:
      return "through_water_m_s";
    case Rule::SurfaceDrift:
      return "surface_drift_m_s";
  }
  return "";
}

EnvironmentCheck::EnvironmentCheck(const platforms::Platform& platform)
    : envelope_(platform.envelope), world_(platform.world) {}

/// `value` is to be `limit` at most; a NaN is not.
void EnvironmentCheck::hold(Rule rule, double time_s, double value, double limit,
                            const char* what) {
  Use& use = uses_.at(static_cast<size_t>(rule));
  ++use.looks;
  use.most = std::max(use.most, limit > 0 ? value / limit : value);
  if (!(value <= limit + kRounding) && !broken_) {
    broken_ = {rule, time_s, fmt::format("{} {:.6g}, at most {:.6g}", what, value, limit)};
  }
}

void EnvironmentCheck::begin(double time_s, double depth_m, bool from_surface) {
  if (from_surface) {
    hold(Rule::Start, time_s, depth_m, world_.start_depth_m, "control is given at depth");
  }
  last_s_ = time_s;
  last_depth_m_ = depth_m;
  deepest_m_ = depth_m + envelope_.inflection_overshoot_m;
  climb_.reset();
}

/// How far a dive goes on until the command that ends it is obeyed, m.
double EnvironmentCheck::goesOn() const {
  const double late_s = 2 * (world_.line_lag_s + envelope_.cycle_s) + world_.command_delay_s;
  return late_s * envelope_.vertical_rate_m_s;
}

void EnvironmentCheck::commandDown(double target_m, double depth_m) {
  // It may still reach what the previous command allowed, but not further beyond where it is.
  const double beyond = envelope_.inflection_overshoot_m;
  deepest_m_ = std::max(target_m + beyond, std::min(deepest_m_, depth_m + goesOn() + beyond));
  climb_.reset();
}

void EnvironmentCheck::commandUp(double target_m, double depth_m, double time_s) {
  const double beyond = envelope_.inflection_overshoot_m;
  // To less than a metre means to the surface. Elsewhere it hovers when it is there, and where it
  // is above it sinks to it.
  constexpr double kToTheSurface = 1;
  const bool hovers = target_m >= kToTheSurface;
  const double lowest_m = hovers ? target_m + beyond + world_.climb_hold_m : target_m;
  // It may have hovered, or not have obeyed the climb before: a new climb.
  const bool early = climb_ && time_s - climb_->since_s < world_.command_delay_s;
  if (!climb_ || lowest_m < climb_->lowest_m || (early && lowest_m > climb_->lowest_m)) {
    deepest_m_ = std::min(deepest_m_, depth_m + goesOn() + beyond);
    climb_ = Climb{time_s, lowest_m};
  }
  climb_->lowest_m = lowest_m;
  deepest_m_ = hovers ? std::max(deepest_m_, lowest_m) : deepest_m_;
}

void EnvironmentCheck::moved(double time_s, double depth_m) {
  const double passed = time_s - last_s_;
  hold(Rule::Above, time_s, -depth_m, 0, "height above the surface");
  if (passed > 0) {
    hold(Rule::Rate, time_s, std::fabs(depth_m - last_depth_m_) / passed,
         envelope_.vertical_rate_m_s, "vertical speed");
  }
  // How far beyond what was commanded, or beyond where it was when it began to turn.
  hold(Rule::Deepest, time_s, depth_m - (deepest_m_ - envelope_.inflection_overshoot_m),
       envelope_.inflection_overshoot_m, "beyond the command by");
  holdClimb(time_s, depth_m);
  last_s_ = time_s;
  last_depth_m_ = depth_m;
}

void EnvironmentCheck::holdClimb(double time_s, double depth_m) {
  const double obeys_s = world_.command_delay_s + world_.turn_s;
  const double climbs_s = climb_ ? time_s - climb_->since_s - obeys_s : -1;
  if (climbs_s < 0) {
    return;
  }
  const double lifted = deepest_m_ - world_.slowest_climb_m_s * climbs_s;
  hold(Rule::Climb, time_s, depth_m, std::max({climb_->lowest_m, 0.0, lifted}),
       "climbing, but at depth");
}

void EnvironmentCheck::floats(double time_s, double depth_m) {
  hold(Rule::Surface, time_s, depth_m, world_.surface_depth_m, "floating at depth");
}

void EnvironmentCheck::ticks(double time_s) {
  if (!std::isnan(last_tick_s_)) {
    hold(Rule::TickGap, time_s, time_s - last_tick_s_, world_.tick_gap_s, "between two ticks");
  }
  last_tick_s_ = time_s;
}

void EnvironmentCheck::sees(double time_s, double reading_m, double depth_m) {
  hold(Rule::Reading, time_s, std::fabs(reading_m - depth_m), world_.depth_error_m,
       "the reading of depth is off by");
}

void EnvironmentCheck::reports(double time_s, const platforms::PlatformSensor& sensor, double raw) {
  const double middle = (sensor.lowest + sensor.highest) / 2;
  hold(Rule::Range, time_s, std::fabs(raw - middle), (sensor.highest - sensor.lowest) / 2,
       sensor.name.c_str());
}

void EnvironmentCheck::drifts(double time_s, double speed_mps) {
  hold(Rule::Drift, time_s, speed_mps, envelope_.drift_m_s, "the water's speed");
}

void EnvironmentCheck::getsOn(double time_s, double speed_mps) {
  hold(Rule::ThroughWater, time_s, speed_mps, world_.through_water_m_s, "speed through the water");
}

void EnvironmentCheck::floatsAlong(double time_s, double speed_mps) {
  hold(Rule::SurfaceDrift, time_s, speed_mps, world_.surface_drift_m_s, "speed at the surface");
}

}  // namespace glider::tests
