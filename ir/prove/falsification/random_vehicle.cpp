// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/falsification/random_vehicle.h"

#include "ir/prove/context/vehicle_rules.h"

#include <algorithm>
#include <cmath>

namespace glider::ir::prove {

RandomVehicle::RandomVehicle(const platforms::Platform& platform, Rng& dice, Manner manner)
    : platform_(platform),
      dice_(dice),
      manner_(manner),
      limits_(platform, dice.within(0, platform.world.start_depth_m)) {}

/// V7.
double RandomVehicle::reading() {
  const double error = platform_.world.depth_error_m;
  return std::max(0.0, depth() + dice_.within(-error, error));
}

void RandomVehicle::obey(const std::vector<Action>& actions, double now) {
  for (const Action& action : actions) {
    if (const auto* command = std::get_if<CommandRun>(&action)) {
      if (!command->refused) {
        limits_.obey(*command, now);
      }
    } else if (dice_.chance(0.5)) {  // a behaviour in C may command anything
      limits_.downTo(depth() + dice_.within(0, platform_.envelope.greatest_depth_m));
    } else {
      limits_.upTo(dice_.within(0, depth()), now);
    }
  }
}

bool RandomVehicle::isAsLateAsItMay() const {
  const bool surfaces = limits_.climbs() && limits_.top() < kFloats;
  return manner_ == Manner::Late || (manner_ == Manner::Shy && surfaces);
}

/// The least depth that it makes for, m.
double RandomVehicle::highestAim() const {
  const double beyond = platform_.envelope.inflection_overshoot_m + platform_.world.climb_hold_m;
  return manner_ == Manner::Shy && limits_.climbs() ? limits_.top() - beyond : 0;
}

void RandomVehicle::move(double from, double to) {
  if (from >= speed_until_) {
    // As often an extreme value as one in between.
    speed_ = dice_.chance(0.5) ? 1 : dice_.unit();
    speed_until_ = from + dice_.lasting();
    sinks_on_ = dice_.chance(0.2);
  }
  const double highest = limits_.highest(from, to);
  const bool down =
      !limits_.climbs() || (sinks_on_ && !rose_) || (depth() < limits_.top() && dice_.chance(0.5));
  if (isAsLateAsItMay()) {
    limits_.moveTo(highest);
    return;
  }
  const double before = depth();
  const double aim = std::min(highest, std::max(limits_.lowest(from, to), highestAim()));
  limits_.moveTo(std::lerp(std::min(depth(), highest), down ? highest : aim, speed_));
  rose_ = limits_.climbs() && (rose_ || depth() < before);
}

}  // namespace glider::ir::prove
