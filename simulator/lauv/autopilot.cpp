// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/lauv/autopilot.h"

#include "hooks/imc/values.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace glider::simulator::lauv {
namespace {

using hooks::imc::FollowState;

constexpr double kTurn = 2 * std::numbers::pi;

/// A target that is given within it is reached, m.
constexpr double kReached_m = 15;
/// A target that it goes to is reached when it would be there so soon, s.
constexpr double kArrives_s = 5;
/// A depth is reached within it, m.
constexpr double kAtDepth_m = 1;

}  // namespace

Autopilot::Autopilot() : doing_(FollowState::Wait) {}

void Autopilot::rest(Vehicle& vehicle) {
  depth_sum_ = speed_sum_ = 0;
  doing_ = FollowState::Wait;
  vehicle.commandPropeller(0);
  vehicle.commandFin(0);
  vehicle.commandSternPlane(0);
}

void Autopilot::turnTo(double heading, Vehicle& vehicle) const {
  constexpr double kGain = 0.6, kDamping = 0.9;
  const double error = std::remainder(heading - vehicle.heading(), kTurn);
  vehicle.commandFin(kGain * error - kDamping * vehicle.turnRate());
}

/// A pitch from the error of the depth, and the planes from the error of the pitch. The sum makes
/// up for the buoyancy.
void Autopilot::pitchFor(double depth_m, Vehicle& vehicle) {
  constexpr double kPerMetre = 0.12, kPerMetreSecond = 0.006, kMostSum = 20;
  constexpr double kGain = 1.2, kDamping = 1.0;
  const double error = depth_m - vehicle.depth();
  const bool near = std::fabs(error) < 2;
  depth_sum_ = near ? std::clamp(depth_sum_ + error * Vehicle::kStep, -kMostSum, kMostSum) : 0;
  const double wanted =
      std::clamp(-(kPerMetre * error + kPerMetreSecond * depth_sum_), -kSteepest, kSteepest);
  vehicle.commandSternPlane(kGain * (wanted - vehicle.pitch()) -
                            kDamping * vehicle.bodyVelocity().pitch);
}

/// As DUNE: more revolutions than the speed needs, and their sum of the error takes them back
/// within a minute. So it overshoots after a start.
void Autopilot::runAt(double speed_mps, Vehicle& vehicle) {
  constexpr double kRpmPerSpeed = 1000, kRpmPerMetre = 25, kMostSum = 400;
  speed_sum_ += kRpmPerMetre * (speed_mps - vehicle.bodyVelocity().surge) * Vehicle::kStep;
  speed_sum_ = std::clamp(speed_sum_, -kMostSum, kMostSum);
  vehicle.commandPropeller(std::max(0.0, kRpmPerSpeed * speed_mps + speed_sum_));
}

/// As DUNE decides it with each Reference: a new one by where the vehicle is then, and one that it
/// has by what it does.
uint8_t Autopilot::next(const Target& target, double away_m, double depth_m) const {
  const bool at_depth = std::fabs(depth_m - target.depth_m) < kAtDepth_m;
  const bool at_surface = target.depth_m <= 0;
  const uint8_t there = !at_depth    ? uint8_t{FollowState::Elevator}
                        : at_surface ? uint8_t{FollowState::Hover}
                                     : uint8_t{FollowState::Loiter};
  if (doing_ == FollowState::Wait || !(target == told_)) {
    return away_m < kReached_m ? there : uint8_t{FollowState::Goto};
  }
  if (doing_ == FollowState::Goto) {
    return away_m < kArrives_s * target.speed_mps ? there : doing_;
  }
  if (doing_ == FollowState::Hover) {
    return away_m < kReached_m ? doing_ : uint8_t{FollowState::Goto};
  }
  return doing_ == FollowState::Elevator ? there : doing_;
}

uint8_t Autopilot::steer(const Target& target, const Planar& here, Vehicle& vehicle) {
  const double east = target.place.east - here.east, north = target.place.north - here.north;
  const double away = std::hypot(east, north);
  const uint8_t doing = next(target, away, vehicle.depth());
  if (doing == FollowState::Hover) {
    rest(vehicle);
  } else {
    double heading = std::atan2(east, north);
    if (doing != FollowState::Goto) {
      // Around the place, which stays to starboard: along the circle, turned towards it from
      // outside.
      const double off = (away - kLoiter_m) / kLoiter_m;
      heading += std::clamp(off, -1.0, 1.0) * std::numbers::pi / 4 - std::numbers::pi / 2;
    }
    turnTo(heading, vehicle);
    pitchFor(std::max(target.depth_m, 0.0), vehicle);
    runAt(target.speed_mps, vehicle);
  }
  told_ = target;
  doing_ = doing;
  return doing;
}

}  // namespace glider::simulator::lauv
