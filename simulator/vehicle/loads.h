// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/vehicle/battery.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace glider::simulator {

/// What a vehicle did in a step, as far as its power table asks.
struct Doings {
  double seconds = 0;
  double depth_m = 0;
  bool at_surface = false;
  bool surfaces = false;  ///< in this step it counts as having surfaced
  double pumped_cc = 0;   ///< outwards
  bool pitch_battery_moves = false;
  bool fin_moves = false;
  double rpm = 0;
  bool sbc_powered = false;
  bool sbc_asleep = false;  ///< while it has power
};

/// The devices of a vehicle that draw power, by its power table.
class Loads {
 public:
  explicit Loads(const BatterySettings& settings);

  /// The mission reads sensors: the vehicle's names.
  void read(std::span<const std::string> sensors);
  /// The SBC orders how often instruments read: a word of hooks/protocol/sampling.h.
  void order(uint32_t sampling);
  /// Draws from `battery` what all devices take in a step.
  void draw(Battery& battery, const Doings& doings) const;
  [[nodiscard]] bool sleepSaves() const { return sbc_asleep_W_ < sbc_W_; }

 private:
  struct Row {
    platforms::Draw draw;
    size_t device = 0;  ///< its place in platforms::devicesOf
    bool is_read = false;
    /// The share of the time for which it is on; none: as its row says.
    std::optional<double> on = {};
  };

  [[nodiscard]] static double joules(const Row& row, const Doings& doings);

  std::vector<Row> rows_;
  platforms::PropellerPower propeller_;
  double sbc_W_ = 0;
  double sbc_asleep_W_ = 0;
  size_t propeller_device_ = 0;  ///< their places, as that of a row
  size_t sbc_device_ = 0;
};

/// The power of a propeller at `rpm`, W: straight between the points of its table.
double powerAt(const platforms::PropellerPower& power, double rpm);

}  // namespace glider::simulator
