// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/falsification/random_vehicle.h"

#include "ir/prove/encoding/world.h"

#include <algorithm>
#include <cmath>

namespace glider::ir::prove {

RandomVehicle::RandomVehicle(const platforms::Platform& platform, Rng& dice, bool late)
    : platform_(platform), dice_(dice), late_(late) {
  depth_ = dice_.within(0, platform_.world.start_depth_m);
  deepest_ = depth_ + platform_.envelope.inflection_overshoot_m;
}

double RandomVehicle::reading() {
  const double error = platform_.world.depth_error_m;
  return std::max(0.0, depth_ + dice_.within(-error, error));
}

void RandomVehicle::obey(const std::vector<Action>& actions, double now) {
  for (const Action& action : actions) {
    if (const auto* command = std::get_if<CommandRun>(&action)) {
      if (!command->refused) {
        obey(*command, now);
      }
    } else {
      // A behaviour in C may command anything.
      dice_.chance(0.5) ? downTo(depth_ + dice_.within(0, platform_.envelope.greatest_depth_m))
                        : upTo(dice_.within(0, depth_), now);
    }
  }
}

void RandomVehicle::obey(const CommandRun& command, double now) {
  switch (command.command) {
    case Command::Descend:
    case Command::Hover:
      downTo(command.arguments.at(0));
      break;
    case Command::Ascend:
      upTo(command.arguments.at(0), now);
      break;
    case Command::Surface:
      upTo(0, now);
      break;
    case Command::Steer:
    case Command::SteerTo:
    case Command::Drift:
      break;
  }
}

void RandomVehicle::downTo(double target) {
  const double overshoot = platform_.envelope.inflection_overshoot_m;
  deepest_ = std::max(target + overshoot, std::min(deepest_, depth_ + overshoot));
  climbing_ = false;
}

void RandomVehicle::upTo(double target, double now) {
  const double overshoot = platform_.envelope.inflection_overshoot_m;
  const bool hovers = target >= kFloats;
  const double top = hovers ? target + overshoot : target;
  if (!climbing_ || top < top_) {
    deepest_ = std::min(deepest_, depth_ + overshoot);
    since_ = now;
  }
  climbing_ = true;
  top_ = top;
  deepest_ = hovers ? std::max(deepest_, top) : deepest_;
}

void RandomVehicle::move(double from, double to) {
  if (from >= speed_until_) {
    // As often an extreme value as one in between.
    speed_ = dice_.chance(0.5) ? 1 : dice_.unit();
    speed_until_ = from + dice_.lasting();
  }
  const double way = platform_.envelope.vertical_rate_m_s * (to - from);
  const double lowest = std::max(0.0, depth_ - way);
  double highest = std::min(deepest_, depth_ + way);
  const double climbs = to - since_ - platform_.world.turn_s;
  if (climbing_ && climbs >= 0) {
    const double lifted = deepest_ - platform_.world.slowest_climb_m_s * climbs;
    highest = std::min(highest, std::max({top_, 0.0, lifted}));
  }
  const bool down = !climbing_ || (depth_ < top_ && dice_.chance(0.5));
  const double speed = !late_ ? speed_ : climbing_ ? 0 : 1;
  depth_ = std::lerp(std::min(depth_, highest), down ? highest : lowest, speed);
}

}  // namespace glider::ir::prove
