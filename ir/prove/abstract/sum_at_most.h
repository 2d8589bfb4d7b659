// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cmath>
#include <limits>

namespace glider::ir::prove {

/// An upper bound of the exact sum: the sum itself if it is a double.
inline double sumAtMost(double a, double b) {
  const double sum = a + b;
  const bool exact = sum - a == b && sum - b == a;
  return exact ? sum : std::nextafter(sum, std::numeric_limits<double>::infinity());
}

}  // namespace glider::ir::prove
