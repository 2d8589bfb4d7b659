// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "compiler/compilation.h"
#include "runtime/abi/glider_abi.h"
#include "simulator/faults/faults.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>

namespace glider::flights {

/// A tick that changed what the vehicle is to do, or the mission's state.
struct LateTick {
  double vehicle_time = 0;  ///< s, when the SBC evaluated it
  double late_s = 0;        ///< since the vehicle composed it
};

/// Watches how late an SBC that sleeps evaluates the ticks that change anything. It goes by the
/// vehicle's time alone, so it says nothing of a flight in which that jumps.
class NapWatch {
 public:
  /// After each poll of the SBC, at the vehicle's time `now_s`.
  void look(const GliderContext& context, double now_s);
  /// The latest; none: no tick changed anything.
  [[nodiscard]] const std::optional<LateTick>& latest() const { return latest_; }

 private:
  /// State and command in force: two kinds and two numbers, then the bits of five values.
  using Order = std::array<uint64_t, 9>;
  static Order orderOf(const GliderContext& context);

  std::optional<Order> order_;
  std::optional<double> at_once_s_;  ///< vehicle's less mission time of a tick that did not wait
  double mission_time_ = 0;
  std::optional<LateTick> latest_;
};

/// What the SBC of `mission` did too late after a sleep. None: nothing, or `faults` has one of a
/// sensor that the mission does not read, or of a clock: then it is not known.
std::optional<LateTick> tooLate(const NapWatch& watch, const compiler::Optimised& mission,
                                std::span<const simulator::SensorFault> faults);

}  // namespace glider::flights
