// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <numbers>
#include <optional>
#include <string_view>

namespace glider::frontend {

/// 360 deg, in radians.
inline constexpr double kFullTurn = 2 * std::numbers::pi;

/// The number written as `digits`; empty if it is too large for a double. Too small for a double
/// gives 0.
std::optional<double> parseNumber(std::string_view digits);

/// A bare position: ddmm.mmmm as the vehicle writes it.
struct DegreesMinutes {
  double degrees = 0;  ///< whole
  double minutes = 0;
  [[nodiscard]] double value() const { return degrees + minutes / 60.0; }
};
/// Degrees of "39.175", "39 10.5" and "3910.5" before a letter: four digits or more before the
/// point are ddmm.mmmm. Empty if a double cannot hold it; the minutes may be 60 or more.
std::optional<DegreesMinutes> parseLettered(std::string_view digits);

/// Splits `digits` (ddmm.mmmm, without sign) into degrees and minutes; the minutes are read from
/// their own digits so that no precision is lost. Empty if a double cannot hold it.
std::optional<DegreesMinutes> parseDegreesMinutes(std::string_view digits);

}  // namespace glider::frontend
