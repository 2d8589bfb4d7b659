// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "platforms/load/platform.h"

#include <algorithm>

namespace glider::simulator {

inline constexpr double kJoulesPerWattHour = 3600;

/// The pack and its loads.
struct BatterySettings {
  double capacity_j = 1;
  double full_V = 1;
  double empty_V = 0;
  double start_V = 1;  ///< without load, when the flight begins
  double hotel_W = 0;
  double sbc_W = 0;  ///< added while the SBC is alive
};

/// Those of a vehicle with a full pack.
inline BatterySettings batteryOf(const platforms::Power& power) {
  constexpr double kJoulesPerKilojoule = 1000;
  return {.capacity_j = power.capacity_kj * kJoulesPerKilojoule,
          .full_V = power.full_V,
          .empty_V = power.empty_V,
          .start_V = power.full_V,
          .hotel_W = power.hotel_W,
          .sbc_W = power.sbc_W};
}

/// The batteries, whose voltage falls linearly with the energy used, and their loads. An empty pack
/// stays at its last voltage.
class Battery {
 public:
  explicit Battery(const BatterySettings& settings = {})
      : settings_(settings),
        used_j_((settings.full_V - settings.start_V) / (settings.full_V - settings.empty_V) *
                settings.capacity_j) {}

  /// The electronics draw their share for `seconds`.
  void idle(double seconds, bool sbc_alive) {
    use((settings_.hotel_W + (sbc_alive ? settings_.sbc_W : 0)) * seconds);
  }
  void use(double joules) { used_j_ = std::min(used_j_ + joules, settings_.capacity_j); }

  [[nodiscard]] double voltage() const {
    return settings_.full_V -
           (settings_.full_V - settings_.empty_V) * used_j_ / settings_.capacity_j;
  }
  [[nodiscard]] double usedJ() const { return used_j_; }  ///< since the pack was full
  [[nodiscard]] double leftJ() const { return settings_.capacity_j - used_j_; }
  /// Used since the pack was full.
  [[nodiscard]] double ampHours() const {
    return used_j_ / (0.5 * (settings_.full_V + voltage())) / 3600;
  }

 private:
  BatterySettings settings_;
  double used_j_;
};

}  // namespace glider::simulator
