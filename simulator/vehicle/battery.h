// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "platforms/load/power.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace glider::simulator {

using platforms::kJoulesPerWattHour;

/// The pack and what it feeds, as a scenario may change it.
struct BatterySettings {
  platforms::Power power;
  double start_V = 1;           ///< without load, when the flight begins
  bool own_capacity = false;    ///< the scenario says how much it holds
  std::optional<double> sbc_W;  ///< while the SBC has power; empty: not known, and not counted
  std::optional<double> sbc_asleep_W;  ///< while it sleeps; empty: as while it does not
};

/// The energy (J) of a full pack that gives `charge_C` until it is empty, at the voltages of
/// `power`: they fall linearly with the energy used.
double energyOfCharge(const platforms::Power& power, double charge_C);

/// Those of a vehicle with a full pack.
BatterySettings batteryOf(const platforms::Power& power);

/// The batteries. Their voltage falls linearly with the energy used, and by what their resistance
/// takes under load. An empty pack gives nothing more.
class Battery {
 public:
  Battery() = default;
  explicit Battery(const BatterySettings& settings);

  /// A device takes energy in this step, if the pack has it. `device`: its place in
  /// platforms::devicesOf.
  void use(size_t device, double joules);
  /// Ends a step of `seconds`.
  void settle(double seconds);

  /// Under the load of the last half minute, as vehicles report it, V.
  [[nodiscard]] double voltage() const;
  [[nodiscard]] double usedJ() const { return used_j_; }  ///< since the pack was full
  [[nodiscard]] double leftJ() const { return capacity_j_ - used_j_; }
  [[nodiscard]] bool empty() const { return !(used_j_ < capacity_j_); }
  [[nodiscard]] double usedByJ(size_t device) const { return by_device_j_[device]; }
  /// The charge since the pack was full.
  [[nodiscard]] double ampHours() const { return coulombs_ / 3600; }

 private:
  [[nodiscard]] double withoutLoad() const;

  double capacity_j_ = 1, full_V_ = 1, empty_V_ = 0, resistance_ohm_ = 0;
  double used_j_ = 0, coulombs_ = 0;
  double step_j_ = 0;  ///< in this step
  double load_W_ = 0;  ///< its mean
  std::vector<double> by_device_j_;
};

}  // namespace glider::simulator
