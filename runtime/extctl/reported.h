// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/extctl/port.h"

#include <stdint.h>

namespace glider::runtime::extctl {

/// The sensors of the port as the vehicle has reported them. It reports changes only, several in a
/// sentence, and the sentences of a control cycle end with the one that has its clock.
class Reported {
 public:
  /// Of the first `count` indices.
  explicit Reported(uint32_t count);

  /// Takes the pairs `index:value` after the name of a sentence, separated by commas. True if the
  /// last index, the clock, is among them with another value than before: the cycle is complete.
  /// Pairs that are none, or of no sensor, are passed over and counted.
  bool take(const char* pairs, uint32_t size);
  /// The newest value; NaN before the first.
  [[nodiscard]] double value(uint32_t index) const { return values_[index]; }
  [[nodiscard]] double value(hooks::extctl::PortSensor sensor) const {
    return values_[static_cast<uint32_t>(sensor)];
  }
  /// Takes the report of a sensor, once: false if there was none since the last time, or none in
  /// the last kKeptSecs by the vehicle's clock. A report that is not taken stays so long: the
  /// vehicle will not repeat it, and what it said before there was a link would be lost.
  bool takeReport(uint32_t index, double* value);
  static constexpr double kKeptSecs = 20;
  /// Pairs passed over.
  [[nodiscard]] uint32_t bad() const { return bad_; }

 private:
  double values_[hooks::extctl::kMostSensors];
  double heard_s_[hooks::extctl::kMostSensors] = {};  ///< by the vehicle's clock
  bool fresh_[hooks::extctl::kMostSensors] = {};
  bool recent_[hooks::extctl::kMostSensors] = {};  ///< reported since the last whole cycle
  uint32_t count_;
  uint32_t bad_ = 0;
};

}  // namespace glider::runtime::extctl
