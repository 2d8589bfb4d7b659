// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/geography/planar.h"
#include "simulator/vehicle/vehicle.h"

#include <cstdint>

namespace glider::simulator::lauv {

/// Where the vehicle is to be: m east and north of the world's origin, m down.
struct Target {
  Planar place;
  double depth_m = 0;
  double speed_mps = 0;

  bool operator==(const Target&) const = default;
};

/// The vehicle's own control of its propeller, rudder and stern planes: to a place, at a speed and
/// a depth. Called in every step of the model.
class Autopilot {
 public:
  Autopilot();
  /// Steers `vehicle`, which takes itself to be at `here`; returns what it does (FollowState).
  uint8_t steer(const Target& target, const Planar& here, Vehicle& vehicle);
  /// Stops the propeller: the vehicle floats up.
  void rest(Vehicle& vehicle);

  /// It pitches by no more to go to a depth, rad.
  static constexpr double kSteepest = 0.2618;
  /// Radius of the circle around a place, m.
  static constexpr double kLoiter_m = 7.5;

 private:
  void turnTo(double heading, Vehicle& vehicle) const;
  void pitchFor(double depth_m, Vehicle& vehicle);
  void runAt(double speed_mps, Vehicle& vehicle);
  [[nodiscard]] uint8_t next(const Target& target, double away_m, double depth_m) const;

  double depth_sum_ = 0;  ///< of the error of the depth, m s
  double speed_sum_ = 0;  ///< what the error of the speed has added, rpm
  Target told_;
  uint8_t doing_;  ///< FollowState, since told_ or later
};

}  // namespace glider::simulator::lauv
