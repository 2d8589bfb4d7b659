// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "platforms/load/platform.h"
#include "simulator/ocean/ocean.h"
#include "simulator/vehicle/battery.h"
#include "simulator/vehicle/body_velocity.h"
#include "simulator/vehicle/flight_model.h"
#include "simulator/vehicle/rate_limited.h"

#include <memory>
#include <string_view>

namespace glider::simulator {

/// What a scenario specifies about the vehicle.
struct VehicleSettings {
  FlightCoefficients flight;        ///< of a vehicle with a propeller only mass and volume
  double positive_buoyancy_kg = 0;  ///< of a vehicle with a propeller, on top of that volume
  double initial_heading_rad = 0;
  double start_x_m = 0, start_y_m = 0;  ///< east and north of the world's origin
  BatterySettings battery = {};
};

/// Those of a vehicle as its platform file describes it; its volume is not set.
VehicleSettings settingsOf(const platforms::Platform& platform);

/// Where a vehicle is and what it does; plain data. Positions in m: x east, y north of the
/// world's origin, depth down.
struct VehicleState {
  double x_m = 0, y_m = 0, depth_m = 0;
  double pitch_rad = 0;
  double heading_rad = 0;  ///< 0…2 pi, clockwise from true north
  double turn_rate_rad_s = 0;
  double ahead_mps = 0, up_mps = 0;  ///< velocity through the water
  RateLimited pump;                  ///< cc
  RateLimited pitch_battery;         ///< in
  RateLimited fin;                   ///< rad; the rudder
  RateLimited rpm;                   ///< of the propeller
  RateLimited stern_plane;           ///< rad
  BodyVelocity body;                 ///< of a vehicle with a propeller
};

/// The commands to its devices.
struct VehicleCommand {
  double pump_cc = 0;
  double pitch_battery_in = 0;
  double fin_rad = 0;
  double rpm = 0;
  double stern_plane_rad = 0;
};

/// How a kind of vehicle moves. It has no state of its own.
class VehicleModel {
 public:
  static constexpr double kStep = 0.25;  ///< s, of every model

  virtual ~VehicleModel() = default;
  /// At the surface before a mission.
  [[nodiscard]] virtual VehicleState start() const = 0;
  /// Advances `state` by kStep seconds from `now_s`, in `ocean`, under `command`.
  virtual void step(VehicleState& state, const VehicleCommand& command, const Ocean& ocean,
                    double now_s) const = 0;
};

/// The model that the platform names; null if there is none of that name, or it names none.
std::unique_ptr<const VehicleModel> makeModel(const platforms::Platform& platform,
                                              const VehicleSettings& settings);
/// Whether there is a model called `name`.
bool isModel(std::string_view name);
/// "only `glider` and `propeller`".
std::string_view knownModels();

}  // namespace glider::simulator
