// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/remus100/override.h"
#include "simulator/vehicle/vehicle.h"

namespace glider::simulator::remus100 {

/// The vehicle's own control of its propeller, rudder and stern planes. Called in every step of the
/// model.
class Autopilot {
 public:
  void steer(const Given& given, Vehicle& vehicle);
  /// Stops the propeller: the vehicle floats up.
  void rest(Vehicle& vehicle);

  /// It pitches by no more to go to a depth, rad: 25 degrees.
  static constexpr double kSteepest = 0.4363;

 private:
  void turnTo(double heading, Vehicle& vehicle) const;
  void pitchFor(double depth_m, Vehicle& vehicle);

  double depth_sum_ = 0;  ///< of the error of the depth, m s
};

}  // namespace glider::simulator::remus100
