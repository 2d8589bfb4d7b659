// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Conversions as the compiler's library has them for a CPU without an FPU. Debian's library is for
// one that has one: it returns doubles there, where code for the 68332 does not look.

#include <stdbool.h>
#include <stdint.h>

double __floatunsidf(uint32_t whole);
double __floatsidf(int32_t whole);
uint32_t __fixunsdfsi(double value);
int32_t __fixdfsi(double value);

typedef union Bits {
  uint64_t bits;
  double value;
} Bits;

enum { kBias = 1023, kFraction = 52 };

double __floatunsidf(uint32_t whole) {
  Bits out = {0};
  if (whole != 0) {
    const uint32_t zeros = (uint32_t)__builtin_clz(whole);
    // The leading one is that of the fraction, which is not kept.
    out.bits = (uint64_t)(whole << zeros) << (kFraction - 31);
    out.bits += (uint64_t)(kBias + 31 - zeros - 1) << kFraction;
  }
  return out.value;
}

double __floatsidf(int32_t whole) {
  const double size = __floatunsidf(whole < 0 ? 0U - (uint32_t)whole : (uint32_t)whole);
  return whole < 0 ? -size : size;
}

/// Without its sign; 0 where it is less than 1.
static uint32_t wholeOf(double value) {
  const Bits in = {.value = value};
  const int32_t exponent = (int32_t)(in.bits >> kFraction & 0x7FF) - kBias;
  if (exponent < 0) {
    return 0;
  }
  if (exponent > 31) {
    return UINT32_MAX;
  }
  const uint64_t fraction = (in.bits & ((UINT64_C(1) << kFraction) - 1)) | UINT64_C(1) << kFraction;
  return (uint32_t)(fraction >> (kFraction - exponent));
}

uint32_t __fixunsdfsi(double value) {
  return value < 0 ? 0 : wholeOf(value);
}

int32_t __fixdfsi(double value) {
  const uint32_t whole = wholeOf(value);
  return value < 0 ? (int32_t)(0U - whole) : (int32_t)whole;
}
