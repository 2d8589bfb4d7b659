// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/vehicle/vehicle_model.h"

#include "simulator/vehicle/glider_model.h"

namespace glider::simulator {
namespace {

constexpr std::string_view kGlider = "glider";

}  // namespace

VehicleSettings settingsOf(const platforms::Platform& platform) {
  VehicleSettings settings;
  if (platform.motion) {
    settings.flight = platform.motion->flight;
    settings.battery = batteryOf(platform.power);
  }
  return settings;
}

bool isModel(std::string_view name) {
  return name == kGlider;
}

std::unique_ptr<const VehicleModel> makeModel(const platforms::Platform& platform,
                                              const VehicleSettings& settings) {
  if (!platform.motion || !isModel(platform.motion->model)) {
    return nullptr;
  }
  return std::make_unique<GliderModel>(*platform.motion, platform.envelope, settings);
}

}  // namespace glider::simulator
