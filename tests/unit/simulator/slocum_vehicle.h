// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "platforms/load/load_platform.h"
#include "simulator/vehicle/vehicle.h"

namespace glider::simulator {

/// The vehicle of platforms/slocum.toml.
inline const platforms::Platform& slocumPlatform() {
  static const platforms::Platform platform =
      platforms::loadPlatform(GLIDER_SOURCE_DIR "/platforms/slocum.toml").value();
  return platform;
}

/// Its settings, neutral in water of 1025 kg/m3.
inline VehicleSettings slocumSettings() {
  VehicleSettings settings = settingsOf(slocumPlatform());
  settings.flight.hull_volume_m3 = settings.flight.mass_kg / 1025;
  return settings;
}

inline Vehicle slocumVehicle(const VehicleSettings& settings = slocumSettings()) {
  return {slocumPlatform(), settings};
}

}  // namespace glider::simulator
