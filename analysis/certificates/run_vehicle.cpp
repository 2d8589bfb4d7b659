// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "analysis/certificates/run_vehicle.h"

#include <algorithm>
#include <cmath>
#include <variant>

namespace glider::analysis {
namespace {

/// Commands to climb to less than this depth mean the surface, m.
constexpr double kSurface = 1;
/// m at a depth of 0; what the sums of a run may be off by.
constexpr double kRounding = 1e-9;

}  // namespace

bool RunVehicle::Depths::contains(double depth_m) const {
  const double rounding = kRounding * (1 + std::fabs(depth_m));
  return depth_m >= least - rounding && depth_m <= greatest + rounding;
}

void RunVehicle::start(double depth_m) {
  depth_ = depth_m;
  deepest_ = depth_m + platform_.envelope.inflection_overshoot_m;
}

RunVehicle::Depths RunVehicle::later(double from, double to) const {
  const double way = platform_.envelope.vertical_rate_m_s * (to - from);
  Depths depths{std::max(0.0, depth_ - way), depth_ + way};
  if (anything_) {
    return depths;
  }
  depths.greatest = std::min(depths.greatest, deepest_);
  const double climbed = to - since_ - platform_.world.command_delay_s - platform_.world.turn_s;
  if (climbing_ && climbed >= 0) {
    const double reached = deepest_ - platform_.world.slowest_climb_m_s * climbed;
    depths.greatest = std::min(depths.greatest, std::max({top_, 0.0, reached}));
  }
  return depths;
}

/// The time in which the vehicle obeys a command: the line and a cycle, for which it may have
/// waited before, and what the seat adds.
double RunVehicle::lateBy() const {
  const platforms::EnvironmentModel& world = platform_.world;
  const double line_s = world.line_lag_s + platform_.envelope.cycle_s;
  return 2 * line_s + world.command_delay_s;
}

/// From now on, until a command that ends a dive is obeyed, and while the vehicle then turns.
double RunVehicle::turnsWithin() const {
  return platform_.envelope.vertical_rate_m_s * lateBy() +
         platform_.envelope.inflection_overshoot_m;
}

double RunVehicle::endOfDive() const {
  return std::min(deepest_, depth_ + turnsWithin());
}

void RunVehicle::obey(const std::vector<ir::Action>& actions, double now) {
  for (const ir::Action& action : actions) {
    if (const auto* command = std::get_if<ir::CommandRun>(&action)) {
      if (!command->refused) {
        obey(*command, now);
      }
    } else {
      anything_ = true;  // V6
    }
  }
}

void RunVehicle::obey(const ir::CommandRun& command, double now) {
  switch (command.command) {
    case ir::Command::Descend:
    case ir::Command::DescendAt:
    case ir::Command::Hover:
      return descend(command.arguments.at(0));
    case ir::Command::Ascend:
    case ir::Command::AscendAt:
      return ascend(command.arguments.at(0), now);
    case ir::Command::Surface:
      return ascend(0, now);
    case ir::Command::Pump:
    case ir::Command::Battery:  // V8
      return descend(platform_.envelope.greatest_depth_m);
    case ir::Command::Steer:
    case ir::Command::SteerTo:
    case ir::Command::Drift:
    case ir::Command::Fin:
      return;
  }
}

/// V3. After a behaviour in C the dive before may have been to any depth.
void RunVehicle::descend(double target) {
  const double overshoot = platform_.envelope.inflection_overshoot_m;
  const double before = anything_ ? depth_ + turnsWithin() : endOfDive();
  deepest_ = std::max(target + overshoot, before);
  climbing_ = false;
  anything_ = false;
}

/// V4. After a behaviour in C the climb may go on that it began, at any time and from any depth.
void RunVehicle::ascend(double target, double now) {
  const bool dives = target >= kSurface;
  const double hold = platform_.world.climb_hold_m + platform_.envelope.inflection_overshoot_m;
  const double top = dives ? target + hold : target;
  // By the port each depth crosses by itself: what follows a surfacing may begin with a dive.
  const bool by_port = platform_.world.command_delay_s > 0;
  const bool old = !by_port || (top_ >= kSurface && now >= since_ + lateBy());
  const bool goes_on = climbing_ && top >= top_ && (top == top_ || old);
  const double end = goes_on ? deepest_ : endOfDive();
  deepest_ = dives ? std::max(top, end) : end;
  since_ = goes_on ? since_ : now;
  top_ = top;
  climbing_ = true;
}

}  // namespace glider::analysis
