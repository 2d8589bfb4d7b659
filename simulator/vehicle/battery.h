// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <algorithm>

namespace glider::simulator {

/// The pack and its loads; an alkaline pack of a shallow vehicle unless a scenario says otherwise.
struct BatterySettings {
  double capacity_j = 8e6;
  double full_V = 14.4;
  double empty_V = 10.0;
  double start_V = 14.4;  ///< without load, when the flight begins
  double hotel_W = 1.63;  ///< median of a real log, submerged with the pump off
  double sbc_W = 0;       ///< added while the SBC is alive
};

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
  /// Used since the pack was full.
  [[nodiscard]] double ampHours() const {
    return used_j_ / (0.5 * (settings_.full_V + voltage())) / 3600;
  }

 private:
  BatterySettings settings_;
  double used_j_;
};

}  // namespace glider::simulator
