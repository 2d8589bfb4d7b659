// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/vehicle/battery.h"

#include <algorithm>
#include <cmath>

namespace glider::simulator {
namespace {

constexpr double kJoulesPerKilojoule = 1000;
/// Vehicles report a voltage that follows the pack's so slowly, s.
constexpr double kVoltageLag = 30;

}  // namespace

double energyOfCharge(const platforms::Power& power, double charge_C) {
  return charge_C * (power.full_V - power.empty_V) / std::log(power.full_V / power.empty_V);
}

BatterySettings batteryOf(const platforms::Power& power) {
  return {.power = power,
          .start_V = power.full_V,
          .own_capacity = false,
          .sbc_W = std::nullopt,
          .sbc_asleep_W = std::nullopt};
}

Battery::Battery(const BatterySettings& settings)
    : capacity_j_(settings.power.capacity_kj * kJoulesPerKilojoule),
      full_V_(settings.power.full_V),
      empty_V_(settings.power.empty_V),
      resistance_ohm_(settings.power.resistance_ohm),
      used_j_((full_V_ - settings.start_V) / (full_V_ - empty_V_) * capacity_j_),
      coulombs_(used_j_ / (0.5 * (full_V_ + settings.start_V))),
      by_device_j_(platforms::devicesOf(settings.power).size(), 0) {}

void Battery::use(size_t device, double joules) {
  const double given = std::min(joules, capacity_j_ - used_j_);
  used_j_ += given;
  step_j_ += given;
  by_device_j_[device] += given;
}

void Battery::settle(double seconds) {
  const double power_W = step_j_ / seconds;
  load_W_ += (power_W - load_W_) * (1 - std::exp(-seconds / kVoltageLag));
  coulombs_ += step_j_ / withoutLoad();
  step_j_ = 0;
}

double Battery::withoutLoad() const {
  return full_V_ - (full_V_ - empty_V_) * used_j_ / capacity_j_;
}

double Battery::voltage() const {
  return withoutLoad() - resistance_ohm_ * load_W_ / withoutLoad();
}

}  // namespace glider::simulator
