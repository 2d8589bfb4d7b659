// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <stdint.h>

/// Numbers as text, as they cross a line. No heap, no libc.
namespace glider::hooks {

/// Reads `count` characters as a decimal number: a sign, digits with at most one point, and perhaps
/// an exponent; "nan" and "inf" in either case are unknown (NaN). Returns false for anything else.
/// The result is at most one unit in the last place from the number that is written.
[[nodiscard]] bool readDecimal(const char* text, uint32_t count, double* value);

/// The most that writeDecimal writes.
inline constexpr uint32_t kMostDecimal = 24;

/// Writes `value` with six decimals, as the vehicle's own text does, and returns the number of
/// characters. A value beyond 1e12 in size is written as that; NaN as "nan".
uint32_t writeDecimal(double value, char* text);

/// `value` as it arrives after it was written and read: rounded to six decimals.
double asSixDecimals(double value);

}  // namespace glider::hooks
