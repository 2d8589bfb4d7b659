// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/abi/glider_abi.h"

#include <string.h>

/// The rule of ir/README.md, decided on the bit pattern: going through memory rounds what a 486
/// holds in a wider register.
extern "C" double gliderSettle(double value) {
  constexpr uint64_t kExponent = 0x7FF0000000000000U;
  constexpr uint64_t kUnknown = 0x7FF8000000000000U;
  uint64_t bits;
  memcpy(&bits, &value, sizeof bits);
  const uint64_t exponent = bits & kExponent;
  if (exponent == kExponent) {
    bits = kUnknown;
  } else if (exponent == 0) {
    bits = 0;
  }
  memcpy(&value, &bits, sizeof bits);
  return value;
}
