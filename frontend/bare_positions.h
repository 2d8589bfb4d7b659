// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <optional>
#include <string>
#include <string_view>

/// Positions in the vehicle's own ddmm.mmmm, without letters: what can be told from the digits.
namespace glider::frontend {

/// A number written without a unit.
struct BareNumber {
  std::string_view digits;
  bool negative = false;
};

/// Whether the digits show that ddmm.mmmm is meant: three or more before the point, or 0. `39.1`
/// can be degrees or minutes; near the equator minutes are written `0039.1`.
bool isPlainlyDdmm(std::string_view digits);

/// Whether two numbers (degrees) in the place of a latitude and a longitude are a longitude and a
/// latitude: the first is no latitude, or it lies beyond 70 degrees and the second within. So near
/// the poles bare positions are refused there; with letters every position can be written.
bool isLongitudeFirst(double first, double second);

/// "39.176667 N 73.831667 W": how the pair `first second` is written, with the latitude first.
/// Empty if not both can be ddmm.mmmm on Earth.
std::optional<std::string> pairWithLetters(const BareNumber& first, const BareNumber& second);

/// "73.83 W": a latitude or longitude with its letter, to a tenth of a metre.
std::string withLetter(double degrees, bool latitude);

/// Whether `3910.6 -7349.9` is meant for two numbers and not for a difference: `before` and `after`
/// say whether blanks stand before and after the minus. Both numbers look like ddmm.mmmm, and the
/// minus sticks to the second only, or both have the fraction of minutes.
bool isPairByLooks(std::string_view first, std::string_view second, bool before, bool after);

}  // namespace glider::frontend
