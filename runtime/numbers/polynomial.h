// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <stdint.h>

namespace glider::runtime {

/// The polynomial's value by Horner's rule; the constant term comes first.
template <uint32_t kCount>
double polynomial(const double (&coefficients)[kCount], double x) {
  double value = coefficients[kCount - 1];
  for (uint32_t i = kCount - 1; i > 0; --i) {
    value = value * x + coefficients[i - 1];
  }
  return value;
}

/// The same, bit for bit, without a loop: the most that it takes is that of its own terms.
template <uint32_t kCount, uint32_t kFrom = 0>
double unrolled(const double (&coefficients)[kCount], double x) {
  if constexpr (kFrom + 1 == kCount) {
    return coefficients[kFrom];
  } else {
    return unrolled<kCount, kFrom + 1>(coefficients, x) * x + coefficients[kFrom];
  }
}

}  // namespace glider::runtime
