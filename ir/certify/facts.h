// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"

#include <vector>

namespace glider::ir::certify {

/// The numbers that the machine may get for an expression when it is known.
struct Range {
  double lowest = 0;
  double highest = 0;
  /// Known operands may give an unknown result, because it is too large.
  bool overflows = false;
  [[nodiscard]] bool isOne() const { return lowest == highest; }
  [[nodiscard]] double magnitude() const;
};

/// What holds of every expression and variable wherever a mission evaluates it, as long as its
/// variables are in their declared ranges (which obligations show).
struct Facts {
  std::vector<Range> ranges;         ///< by expression
  std::vector<bool> whole;           ///< by expression
  std::vector<bool> whole_variable;  ///< by variable
  /// By expression: a clock, or a variable that keeps a mission time. Multiples of 2^-22 s below
  /// kLastSecond, so their differences are exact.
  std::vector<bool> on_clock_grid;
  std::vector<Range> declared;  ///< by variable
};

Facts factsOf(const Mission& mission);

/// N1, N3: no known number is beyond these.
inline constexpr double kLargest = 0x1.fffffffffffffp1023;
/// N3: a result of this magnitude or less becomes 0.
inline constexpr double kTiny = 0x1p-1022;
/// Clocks and ages, s: docs/verification.md (Numbers) takes them as multiples of 2^-22 s without
/// rounding, so they are below 2^31 s.
inline constexpr double kLastSecond = 0x1p31;

/// What a window gives for readings in the range `of` (W7 and the other windows).
Range windowRange(TemporalKind kind, const Range& of);

/// The readings of a sensor that step 2 makes known.
Range rangeOfReadings(const Sensor& sensor);

}  // namespace glider::ir::certify
