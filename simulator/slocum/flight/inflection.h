// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/vehicle/vehicle.h"

#include <cstdint>

namespace glider::simulator {

/// The turn from a dive to a climb or back: the vehicle moves its ballast and its pitch battery one
/// after the other, and follows no other command for them until both have arrived. The ballast
/// moves first if the battery's move supports it (aft to climb, forward to dive), else the battery.
class Inflection {
 public:
  struct Targets {
    double pump_cc = 0, battery_in = 0;  ///< within the limits of the motors
  };
  /// True if `to` is on the other side of neutral ballast, more than half the pump's range away,
  /// and the battery must move too.
  [[nodiscard]] static bool isNeeded(const Targets& to, const Vehicle& vehicle);

  void begin(const Targets& to, const Vehicle& vehicle);
  [[nodiscard]] bool active() const { return stage_ != Stage::Done; }
  /// One control cycle: commands the motor whose turn it is.
  void cycle(Vehicle& vehicle);

 private:
  enum class Stage : uint8_t { First, Second, Done };
  [[nodiscard]] bool arrived(bool ballast, const Vehicle& vehicle) const;
  void command(bool ballast, Vehicle& vehicle) const;

  Stage stage_ = Stage::Done;
  bool ballast_first_ = true;
  Targets to_;
};

}  // namespace glider::simulator
