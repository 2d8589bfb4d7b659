// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/ocean/ocean.h"
#include "simulator/vehicle/battery.h"
#include "simulator/vehicle/flight_model.h"
#include "simulator/vehicle/rate_limited.h"

namespace glider::simulator {

/// What a scenario may say of the vehicle.
struct VehicleSettings {
  FlightCoefficients flight;
  double initial_heading_rad = 0;
  BatterySettings battery = {};
};

/// The true vehicle in the true ocean. Positions in m: x east, y north of the start, depth down.
/// Moved in steps of a fixed length of virtual time.
class Vehicle {
 public:
  static constexpr double kStep = 0.25;        ///< s
  static constexpr double kPumpLimitCc = 233;  ///< safety limit 243 less a dead zone of 10
  static constexpr double kBatteryLimitIn = 1.425;
  static constexpr double kFinLimitRad = 0.45;  ///< 0.47 less 0.02

  explicit Vehicle(const VehicleSettings& settings);

  // What the devices are told.
  void commandPump(double cc) { pump_.target = cc; }
  void commandBatteryPosition(double inches) { battery_position_.target = inches; }
  void commandFin(double rad) { fin_.target = rad; }

  /// Says whether the SBC draws its power.
  void feedSbc(bool alive) { sbc_alive_ = alive; }

  /// Flies kStep seconds from time `now_s`.
  void step(const Ocean& ocean, double now_s);

  [[nodiscard]] double x() const { return x_; }
  [[nodiscard]] double y() const { return y_; }
  [[nodiscard]] double depth() const { return depth_; }
  [[nodiscard]] double pitch() const { return pitch_; }
  [[nodiscard]] double heading() const { return heading_; }  ///< 0…2 pi, clockwise from north
  [[nodiscard]] double pumpedCc() const { return pump_.position; }
  [[nodiscard]] double batteryPositionIn() const { return battery_position_.position; }
  [[nodiscard]] double fin() const { return fin_.position; }
  [[nodiscard]] const Battery& battery() const { return battery_; }

 private:
  void movePitch();
  void turn(double speed);
  void limitDepth(double water_depth);

  FlightCoefficients coefficients_;
  RateLimited pump_;
  RateLimited battery_position_;
  RateLimited fin_;
  Battery battery_;
  bool sbc_alive_ = false;
  double x_ = 0, y_ = 0, depth_ = 0;
  double pitch_ = 0;
  double heading_ = 0, turn_rate_ = 0;
  double ahead_ = 0, up_ = 0;  ///< velocity through the water
};

}  // namespace glider::simulator
