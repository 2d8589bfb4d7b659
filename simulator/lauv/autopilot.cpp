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

/// As DUNE converts a speed: 900 rpm make 1.0 m/s, 1150 rpm 1.3 m/s.
double rpmOf(double speed_mps) {
  constexpr double kRpm = 900, kRpmPerSpeed = 833.3;
  return speed_mps <= 0 ? 0 : std::max(0.0, kRpm + (speed_mps - 1) * kRpmPerSpeed);
}

/// A place is reached within it, m.
constexpr double kReached_m = 15;
/// It is at the surface above, m.
constexpr double kAfloat_m = 0.3;

}  // namespace

void Autopilot::rest(Vehicle& vehicle) {
  depth_sum_ = 0;
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

uint8_t Autopilot::steer(const Target& target, const Planar& here, Vehicle& vehicle) {
  const double east = target.place.east - here.east, north = target.place.north - here.north;
  const double away = std::hypot(east, north);
  const double reached = kReached_m + std::fabs(target.loiter_m);
  const bool at_surface = target.depth_m <= 0;
  if (at_surface && away < reached && vehicle.depth() < kAfloat_m) {
    rest(vehicle);
    return FollowState::Hover;
  }
  double heading = std::atan2(east, north);
  if (away < reached) {
    // Around the place, which stays to starboard: along the circle, turned towards it from outside.
    const double off = (away - std::max(target.loiter_m, 1.0)) / std::max(target.loiter_m, 1.0);
    heading += std::clamp(off, -1.0, 1.0) * std::numbers::pi / 4 - std::numbers::pi / 2;
  }
  turnTo(heading, vehicle);
  pitchFor(std::max(target.depth_m, 0.0), vehicle);
  vehicle.commandPropeller(rpmOf(target.speed_mps));
  const bool at_depth = std::fabs(vehicle.depth() - target.depth_m) < 1;
  return away >= reached ? FollowState::Goto
         : at_depth      ? FollowState::Loiter
                         : FollowState::Elevator;
}

}  // namespace glider::simulator::lauv
