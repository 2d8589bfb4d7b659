// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "platforms/load/load_platform.h"
#include "simulator/vehicle/propeller_model.h"

#include <algorithm>
#include <numbers>
#include <string>

/// The vehicles with a propeller, for tests.
namespace glider::simulator {

inline constexpr double kDegree = std::numbers::pi / 180;

/// platforms/NAME.toml.
inline const platforms::Platform& propelledPlatform(const std::string& name) {
  static const auto load = [](const char* file) {
    return platforms::loadPlatform(std::string(GLIDER_SOURCE_DIR "/platforms/") + file + ".toml")
        .value();
  };
  static const platforms::Platform lauv = load("lauv"), remus = load("remus100");
  return name == "lauv" ? lauv : remus;
}

/// Ballasted for water of 1025 kg/m3; `buoyancy_kg` in place of the platform's.
inline VehicleSettings propelledSettings(const platforms::Platform& platform, double buoyancy_kg) {
  VehicleSettings settings = settingsOf(platform);
  settings.flight.hull_volume_m3 = settings.flight.mass_kg / 1025;
  settings.positive_buoyancy_kg = buoyancy_kg;
  return settings;
}

/// Water of 1025 kg/m3 at the surface.
inline OceanSettings propelledWater(double depth_m) {
  OceanSettings settings;
  settings.density = 1025;
  settings.bottom.depth_m = depth_m;
  return settings;
}

/// One of them in one ocean, from `depth_m` on.
class PropelledFlight {
  const platforms::Platform& platform_;
  PropellerModel model_;
  Ocean ocean_;

 public:
  VehicleState state;
  VehicleCommand command;
  double now = 0;

  PropelledFlight(const std::string& name, double buoyancy_kg, const OceanSettings& water,
                  double depth_m)
      : platform_(propelledPlatform(name)),
        model_(*platform_.motion->propelled, propelledSettings(platform_, buoyancy_kg)),
        ocean_(water),
        state(model_.start()) {
    state.depth_m = depth_m;
  }

  void fly(double seconds) {
    for (const double end = now + seconds; now < end - 1e-9; now += VehicleModel::kStep) {
      model_.step(state, command, ocean_, now);
    }
  }
};

/// DUNE's control of depth and pitch, by its gains; `steepest_rad`: the pitch that it may take.
inline void steerToDepth(PropelledFlight& flight, double depth_m, double steepest_rad) {
  const double pitch =
      std::clamp(0.6 * (flight.state.depth_m - depth_m), -steepest_rad, steepest_rad);
  flight.command.stern_plane_rad =
      1.5 * (pitch - flight.state.pitch_rad) - 1.1 * flight.state.body.pitch;
}

inline double buoyancyOf(const std::string& name) {
  return propelledPlatform(name).motion->propelled->hull.positive_buoyancy_kg;
}

}  // namespace glider::simulator
