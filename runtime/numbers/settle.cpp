// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/abi/glider_abi.h"

#include <string.h>

/// The rule of ir/README.md, decided on the bit pattern. Never inlined: the call takes the value through
/// memory, which rounds what a 486 holds in a wider register; inlined, an optimiser may decide on the
/// register instead.
extern "C" [[gnu::noinline]] double gliderSettle(double value) {
  constexpr uint64_t kSign = 0x8000000000000000U;
  constexpr uint64_t kInfinity = 0x7FF0000000000000U;
  constexpr uint64_t kUnknown = 0x7FF8000000000000U;
  constexpr uint64_t kSmallestNormal = 0x0010000000000000U;
  uint64_t bits;
  memcpy(&bits, &value, sizeof bits);
  const uint64_t magnitude = bits & ~kSign;
  if (magnitude >= kInfinity) {
    bits = kUnknown;
  } else if (magnitude <= kSmallestNormal) {
    bits = 0;
  }
  memcpy(&value, &bits, sizeof bits);
  return value;
}
