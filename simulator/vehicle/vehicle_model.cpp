// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/vehicle/vehicle_model.h"

#include "simulator/vehicle/glider_model.h"
#include "simulator/vehicle/propeller_model.h"

namespace glider::simulator {
namespace {

constexpr std::string_view kGlider = "glider", kPropeller = "propeller";

}  // namespace

VehicleSettings settingsOf(const platforms::Platform& platform) {
  VehicleSettings settings;
  if (platform.motion) {
    settings.flight = platform.motion->flight;
    settings.battery = batteryOf(platform.power);
    if (platform.motion->propelled) {
      settings.flight.mass_kg = platform.motion->propelled->hull.mass_kg;
      settings.positive_buoyancy_kg = platform.motion->propelled->hull.positive_buoyancy_kg;
    }
  }
  return settings;
}

bool isModel(std::string_view name) {
  return name == kGlider || name == kPropeller;
}

std::string_view knownModels() {
  return "only `glider` and `propeller`";
}

std::unique_ptr<const VehicleModel> makeModel(const platforms::Platform& platform,
                                              const VehicleSettings& settings) {
  if (!platform.motion || !isModel(platform.motion->model)) {
    return nullptr;
  }
  if (platform.motion->propelled) {
    return std::make_unique<PropellerModel>(*platform.motion->propelled, settings);
  }
  return std::make_unique<GliderModel>(*platform.motion, platform.envelope, settings);
}

}  // namespace glider::simulator
