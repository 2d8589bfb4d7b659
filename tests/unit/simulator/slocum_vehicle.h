// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "platforms/load/platform.h"
#include "simulator/vehicle/vehicle.h"

namespace glider::simulator {

/// The vehicle of platforms/slocum.toml.
inline const platforms::Platform& slocumPlatform() {
  static const platforms::Platform platform =
      platforms::loadPlatform(GLIDER_SOURCE_DIR "/platforms/slocum.toml").value();
  return platform;
}

inline Vehicle slocumVehicle(const VehicleSettings& settings = {}) {
  return {slocumPlatform(), settings};
}

}  // namespace glider::simulator
