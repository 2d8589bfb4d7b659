// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/numbers/numbers.h"

namespace glider::runtime {
namespace {

constexpr uint32_t kFractionBits = 52;
constexpr uint64_t kHiddenBit = uint64_t{1} << kFractionBits;

uint32_t exponentOf(uint64_t bits) {
  return static_cast<uint32_t>(bits >> kFractionBits);
}

/// The fraction of a normal number with its leading one.
uint64_t digitsOf(uint64_t bits) {
  return (bits & (kHiddenBit - 1)) | kHiddenBit;
}

}  // namespace

/// Long division, one binary digit per step, on whole numbers: a board's soft floating point is
/// slow, and fmod slower.
[[gnu::noinline]] double restOf(double size, double of) {
  const uint64_t bits = bitsOf(size);
  const uint64_t divisor = digitsOf(bitsOf(of));
  uint32_t exponent = exponentOf(bitsOf(of));
  if (bits < bitsOf(of)) {
    return size;
  }
  if (!isFinite(size)) {
    return unknown();
  }
  uint64_t rest = digitsOf(bits);
  for (uint32_t digits = exponentOf(bits) - exponent;; --digits) {
    rest -= rest >= divisor ? divisor : 0;
    if (digits == 0) {
      break;
    }
    rest <<= 1U;
  }
  if (rest == 0) {
    return 0.0;
  }
  while ((rest & kHiddenBit) == 0) {
    rest <<= 1U;
    --exponent;
  }
  return doubleOf((rest & (kHiddenBit - 1)) | (static_cast<uint64_t>(exponent) << kFractionBits));
}

}  // namespace glider::runtime
