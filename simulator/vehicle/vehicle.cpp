// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/vehicle/vehicle.h"

#include "support/check.h"

namespace glider::simulator {

Vehicle::Vehicle(const platforms::Platform& platform, const VehicleSettings& settings)
    : model_(makeModel(platform, settings)) {
  CHECK(model_, "a vehicle without a model");
  limits_ = {platform.envelope.pump_cc, platform.motion->pitch_battery_limit_in,
             platform.envelope.fin_rad};
  if (const auto& propelled = platform.motion->propelled) {
    limits_ = {.fin_rad = propelled->fins.rudder_rad,
               .rpm = propelled->propeller.greatest_rpm,
               .stern_plane_rad = propelled->fins.stern_plane_rad};
  }
  state_ = model_->start();
  command_.pump_cc = state_.pump.position;  // nothing moves before it is commanded
}

}  // namespace glider::simulator
