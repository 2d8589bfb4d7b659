// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/expressions/literals.h"

#include <algorithm>
#include <cfloat>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <string>

namespace glider::frontend {

std::optional<double> parseNumber(std::string_view digits) {
  double value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error == std::errc::result_out_of_range) {
    // from_chars does not say whether it overflowed or underflowed; strtod does.
    value = std::strtod(std::string(digits).c_str(), nullptr);
  }
  if (!std::isfinite(value)) {
    return std::nullopt;
  }
  return value < DBL_MIN ? 0.0 : value;
}

std::optional<DegreesMinutes> parseDegreesMinutes(std::string_view digits) {
  constexpr double kDegree = 100;  // ddmm.mmmm: the degrees are multiples of 100
  const std::optional<double> whole = parseNumber(digits);
  if (!whole) {
    return std::nullopt;
  }
  const double degrees = std::floor(*whole / kDegree);
  if (digits.find_first_of("eE") != std::string_view::npos) {
    return DegreesMinutes{degrees, *whole - degrees * kDegree};
  }
  const size_t point = std::min(digits.find('.'), digits.size());
  const size_t split = point > 2 ? point - 2 : 0;
  return DegreesMinutes{degrees, parseNumber(digits.substr(split)).value_or(0)};
}

std::optional<DegreesMinutes> parseLettered(std::string_view digits) {
  constexpr size_t kFewestDdmm = 4;  // 139.5 E is decimal degrees
  if (const size_t gap = digits.find(' '); gap != std::string_view::npos) {
    const auto degrees = parseNumber(digits.substr(0, gap));
    const auto minutes = parseNumber(digits.substr(gap + 1));
    return degrees && minutes ? std::optional(DegreesMinutes{*degrees, *minutes}) : std::nullopt;
  }
  if (std::min(digits.find_first_not_of("0123456789"), digits.size()) >= kFewestDdmm) {
    return parseDegreesMinutes(digits);
  }
  const auto degrees = parseNumber(digits);
  return degrees ? std::optional(DegreesMinutes{*degrees, 0}) : std::nullopt;
}

}  // namespace glider::frontend
