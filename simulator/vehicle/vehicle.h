// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/vehicle/loads.h"
#include "simulator/vehicle/vehicle_model.h"

#include <cstddef>
#include <memory>
#include <span>
#include <string>

namespace glider::simulator {

/// How far the motors can be commanded in either direction, the propeller ahead; 0: the vehicle
/// has none.
struct MotorLimits {
  double pump_cc = 0;
  double pitch_battery_in = 0;
  double fin_rad = 0;
  double rpm = 0;
  double stern_plane_rad = 0;
};

/// The true vehicle in the true ocean: a model, its state and the last commands to its devices.
class Vehicle {
 public:
  static constexpr double kStep = VehicleModel::kStep;  ///< s

  /// `platform` is one that the simulator can fly (checkPlatform).
  Vehicle(const platforms::Platform& platform, const VehicleSettings& settings);

  void commandPump(double cc) { command_.pump_cc = cc; }
  void commandBatteryPosition(double inches) { command_.pitch_battery_in = inches; }
  /// The fin of a glider, the rudder of a vehicle with a propeller.
  void commandFin(double rad) { command_.fin_rad = rad; }
  void commandPropeller(double rpm) { command_.rpm = rpm; }
  void commandSternPlane(double rad) { command_.stern_plane_rad = rad; }
  /// Sets whether the SBC draws its power.
  /// Whether the SBC takes less while it sleeps.
  [[nodiscard]] bool sleepSaves() const { return loads_.sleepSaves(); }
  void feedSbc(bool powered, bool asleep = false) {
    sbc_powered_ = powered;
    sbc_asleep_ = asleep;
  }
  /// The mission reads these sensors, by the vehicle's names: what measures them draws its power.
  void readSensors(std::span<const std::string> sensors) { loads_.read(sensors); }
  /// The SBC orders how often they read: a word of hooks/protocol/sampling.h.
  void switchInstruments(uint32_t sampling) { loads_.order(sampling); }

  /// The acoustic modem draws energy.
  void useByModem(double joules);

  /// Flies kStep seconds from time `now_s`. With an empty pack no motor moves any more, and a
  /// propeller does not turn.
  void step(const Ocean& ocean, double now_s);

  [[nodiscard]] const MotorLimits& limits() const { return limits_; }
  [[nodiscard]] double x() const { return state_.x_m; }
  [[nodiscard]] double y() const { return state_.y_m; }
  [[nodiscard]] double depth() const { return state_.depth_m; }
  [[nodiscard]] double pitch() const { return state_.pitch_rad; }
  [[nodiscard]] double heading() const {
    return state_.heading_rad;
  }  ///< clockwise from true north
  [[nodiscard]] double pumpedCc() const { return state_.pump.position; }
  [[nodiscard]] double batteryPositionIn() const { return state_.pitch_battery.position; }
  [[nodiscard]] double fin() const { return state_.fin.position; }
  [[nodiscard]] double rpm() const { return state_.rpm.position; }
  [[nodiscard]] double sternPlane() const { return state_.stern_plane.position; }
  /// Velocity through the water: horizontally ahead, up, and clockwise.
  [[nodiscard]] double aheadMps() const { return state_.ahead_mps; }
  [[nodiscard]] double upMps() const { return state_.up_mps; }
  [[nodiscard]] double turnRate() const { return state_.turn_rate_rad_s; }
  /// The same along the axes of the hull, of a vehicle with a propeller.
  [[nodiscard]] const BodyVelocity& bodyVelocity() const { return state_.body; }
  [[nodiscard]] const Battery& battery() const { return battery_; }

 private:
  [[nodiscard]] VehicleCommand withoutPower() const;
  void drawPower(double pump_cc, double pitch_battery_in, double fin_rad);

  std::unique_ptr<const VehicleModel> model_;
  MotorLimits limits_;
  VehicleState state_;
  VehicleCommand command_;
  Battery battery_;
  Loads loads_;
  size_t modem_device_;  ///< its place in platforms::devicesOf
  bool sbc_powered_ = false;
  bool sbc_asleep_ = false;
  bool dived_ = false;    ///< since it last surfaced
  double surface_s_ = 0;  ///< at the surface without a break
};

}  // namespace glider::simulator
