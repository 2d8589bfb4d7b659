// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/remus100/autopilot.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace glider::simulator::remus100 {
namespace {

/// The steady speeds of the model in platforms/remus100.toml: 0.00167 m/s for each turn a minute.
double rpmOf(double speed_m_s) {
  constexpr double kSpeedPerRpm = 0.00167;
  return std::max(speed_m_s, 0.0) / kSpeedPerRpm;
}

}  // namespace

void Autopilot::rest(Vehicle& vehicle) {
  depth_sum_ = 0;
  vehicle.commandPropeller(0);
  vehicle.commandFin(0);
  vehicle.commandSternPlane(0);
}

void Autopilot::turnTo(double heading, Vehicle& vehicle) const {
  constexpr double kGain = 0.6, kDamping = 0.9;
  const double error = std::remainder(heading - vehicle.heading(), 2 * std::numbers::pi);
  vehicle.commandFin(kGain * error - kDamping * vehicle.turnRate());
}

/// A pitch from the error of the depth, and the planes from the error of the pitch. The sum makes
/// up for the buoyancy.
void Autopilot::pitchFor(double depth_m, Vehicle& vehicle) {
  constexpr double kPerMetre = 0.1, kPerMetreSecond = 0.004, kMostSum = 30;
  constexpr double kGain = 1.2, kDamping = 1.0;
  const double error = depth_m - vehicle.depth();
  const bool near = std::fabs(error) < 2;
  depth_sum_ = near ? std::clamp(depth_sum_ + error * Vehicle::kStep, -kMostSum, kMostSum) : 0;
  const double wanted =
      std::clamp(-(kPerMetre * error + kPerMetreSecond * depth_sum_), -kSteepest, kSteepest);
  vehicle.commandSternPlane(kGain * (wanted - vehicle.pitch()) -
                            kDamping * vehicle.bodyVelocity().pitch);
}

void Autopilot::steer(const Given& given, Vehicle& vehicle) {
  turnTo(given.heading_deg * std::numbers::pi / 180, vehicle);
  pitchFor(std::max(given.depth_m, 0.0), vehicle);
  vehicle.commandPropeller(rpmOf(given.speed_m_s));
}

}  // namespace glider::simulator::remus100
