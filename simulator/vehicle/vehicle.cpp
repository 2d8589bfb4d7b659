// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/vehicle/vehicle.h"

#include "support/check.h"

namespace glider::simulator {
namespace {

// m: the antenna is out of the water; and a dive that deserves the name.
constexpr double kSurface = 0.5, kDived = 3;
// s: who stays so long has surfaced, and has not only turned there.
constexpr double kStays = 60;

}  // namespace

Vehicle::Vehicle(const platforms::Platform& platform, const VehicleSettings& settings)
    : model_(makeModel(platform, settings)),
      battery_(settings.battery),
      loads_(settings.battery),
      modem_device_(platforms::placeOf(settings.battery.power, platforms::kModemDevice)) {
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

void Vehicle::useByModem(double joules) {
  battery_.use(modem_device_, joules);
}

VehicleCommand Vehicle::withoutPower() const {
  return {.pump_cc = state_.pump.position,
          .pitch_battery_in = state_.pitch_battery.position,
          .fin_rad = state_.fin.position,
          .rpm = 0,
          .stern_plane_rad = state_.stern_plane.position};
}

void Vehicle::step(const Ocean& ocean, double now_s) {
  const double pump_cc = state_.pump.position;
  const double pitch_battery_in = state_.pitch_battery.position;
  const double fin_rad = state_.fin.position;
  model_->step(state_, battery_.empty() ? withoutPower() : command_, ocean, now_s);
  drawPower(pump_cc, pitch_battery_in, fin_rad);
}

/// What the step took in which the motors have moved from these positions.
void Vehicle::drawPower(double pump_cc, double pitch_battery_in, double fin_rad) {
  const bool at_surface = state_.depth_m < kSurface;
  surface_s_ = at_surface ? surface_s_ + kStep : 0;
  const bool surfaces = dived_ && surface_s_ >= kStays;
  loads_.draw(battery_, {.seconds = kStep,
                         .depth_m = state_.depth_m,
                         .at_surface = at_surface,
                         .surfaces = surfaces,
                         .pumped_cc = state_.pump.position - pump_cc,
                         .pitch_battery_moves = state_.pitch_battery.position != pitch_battery_in,
                         .fin_moves = state_.fin.position != fin_rad,
                         .rpm = state_.rpm.position,
                         .sbc_powered = sbc_powered_,
                         .sbc_asleep = sbc_asleep_});
  battery_.settle(kStep);
  dived_ = state_.depth_m > kDived || (dived_ && !surfaces);
}

}  // namespace glider::simulator
