// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <optional>
#include <string>
#include <string_view>

/// Positions in the vehicle's own ddmm.mmmm, without letters: what follows from the digits.
namespace glider::frontend {

/// A number written without a unit.
struct BareNumber {
  std::string_view digits;
  bool negative = false;
};

/// The number written as `digits`.
double valueOf(std::string_view digits);

/// Whether the digits show that ddmm.mmmm is meant: three or more before the point, or 0. `39.1`
/// can be degrees or minutes; near the equator minutes are written as `0039.1`.
bool isPlainlyDdmm(std::string_view digits);

/// Whether two numbers (degrees) where a latitude and a longitude are expected are a longitude and
/// a latitude: the first is not a valid latitude, or it is beyond 70 degrees and the second is
/// within. So bare positions near the poles are refused there; with letters every position can be
/// written.
bool isLongitudeFirst(double first, double second);

/// "39.176667 N 73.831667 W": the pair `first second` with letters, the latitude first. Empty
/// unless both can be ddmm.mmmm on Earth.
std::optional<std::string> pairWithLetters(const BareNumber& first, const BareNumber& second);

/// "73.83 W": a latitude or longitude with its letter, to a tenth of a metre.
std::string withLetter(double degrees, bool latitude);

/// Whether `3910.6 -7349.9` means two numbers and not a difference: `before` and `after` say
/// whether there are spaces before and after the minus. Both numbers look like ddmm.mmmm, and
/// either only the second is next to the minus, or both have a fraction of minutes.
bool isPairByLooks(std::string_view first, std::string_view second, bool before, bool after);

}  // namespace glider::frontend
