// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/falsification/random_place.h"

#include "ir/core/inside.h"
#include "ir/eval/arithmetic.h"
#include "ir/prove/context/commands.h"
#include "ir/prove/geometry/sphere.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace glider::ir::prove {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

/// A vehicle that dives and climbs moves ahead by as much as its slowest climb at the usual pitch
/// does, m/s.
double slowestSpeed(const platforms::Platform& platform) {
  const double pitch = platform.envelope.usual_pitch_rad;
  return pitch > 0 ? platform.world.slowest_climb_m_s / std::tan(pitch) : 0;
}

}  // namespace

std::optional<Position> placeInside(const Geofence& area, Rng& dice) {
  constexpr int kTries = 1000;
  const std::vector<Position>& corners = area.corners;
  for (int i = 0; i < kTries; ++i) {
    const size_t first = dice.below(corners.size());
    const Position& from = corners[first];
    const double along = dice.within(0, 1), across = dice.within(0, 1);
    Position place = from;
    const auto go = [&](size_t steps, double share) {
      const Position& to = corners[(first + steps) % corners.size()];
      place.latitude += share * (to.latitude - from.latitude);
      place.longitude += share * std::remainder(to.longitude - from.longitude, 360);
    };
    go(1, along * (1 - across));
    go(2, along * across);
    place.longitude = std::remainder(place.longitude, 360);
    if (isInside(area, place)) {
      return place;
    }
  }
  return std::nullopt;
}

RandomPlace::RandomPlace(const Position& start, const platforms::Platform& platform, Rng& dice)
    : platform_(platform), dice_(dice), place_(start) {
  heading_ = dice_.within(0, kTurn);
  set_ = dice_.within(0, kTurn);
  // As often an extreme value as one in between.
  speed_ = std::max(platform_.world.through_water_m_s * (dice_.chance(0.5) ? 1 : dice_.unit()),
                    slowestSpeed(platform_));
  const double strength = dice_.chance(0.7) ? 1 : dice_.unit();
  drift_ = platform_.envelope.drift_m_s * strength;
  surface_drift_ = platform_.world.surface_drift_m_s * strength;
}

void RandomPlace::obey(const std::vector<Action>& actions) {
  for (const Action& action : actions) {
    const auto* run = std::get_if<CommandRun>(&action);
    if (run == nullptr) {
      // A profile or route in C may command anything.
      heading_ = dice_.within(0, kTurn);
      target_.reset();
      turn_ = 0;
    } else if (!run->refused && !isVertical(run->command)) {
      steer(*run);
    }
  }
}

void RandomPlace::steer(const CommandRun& run) {
  target_.reset();
  turn_ = 0;
  if (run.command == Command::SteerTo) {
    target_ = Position{run.arguments.at(0), run.arguments.at(1)};
  } else if (run.command == Command::Steer) {
    heading_ = run.arguments.at(0);
  } else if (run.command == Command::Fin && platform_.motion) {
    turn_ = platform_.motion->yaw_gain_rad_s_m2 * std::sin(run.arguments.at(0)) * speed_ * speed_;
  }
}

double RandomPlace::course() {
  if (!target_) {
    return heading_;
  }
  const double bearing = onEarth(Op::Bearing, place_, *target_);
  return bearing == bearing ? bearing : heading_;  // unknown exactly at the target
}

void RandomPlace::move(double seconds, bool at_surface, bool dark) {
  // What glides gets ahead only while it dives or climbs; without the SBC it may.
  const bool rests = at_surface && !dark && !platform_.envelope.steersBySpeed();
  const double way = rests ? 0 : speed_ * seconds;
  heading_ += turn_ * seconds;
  if (dark) {
    go(dice_.within(0, kTurn), way);
  } else {
    go(course(), target_ ? std::min(way, onEarth(Op::Distance, place_, *target_)) : way);
  }
  go(set_, (at_surface ? surface_drift_ : drift_) * seconds);
}

void RandomPlace::go(double course, double metres) {
  place_.latitude =
      std::clamp(place_.latitude + std::cos(course) * metres / kMetresPerDegree, -89.0, 89.0);
  const double narrow = std::cos(place_.latitude * std::numbers::pi / 180);
  place_.longitude = std::remainder(
      place_.longitude + std::sin(course) * metres / (kMetresPerDegree * narrow), 360);
}

}  // namespace glider::ir::prove
