// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Addition and subtraction of doubles for an ARM without FPU: libgcc's, except for one kind of
// operands. Where numbers are subtracted of which one has 2^33 times the other's unit, libgcc
// shifts out one bit and the 32 below it, and keeps these as one that is not 0. If the result falls
// below a power of two, their first bit is the one that decides the rounding, and a third of such
// results are wrong in the last bit. All other sums are those of other boards.
#include <stdbool.h>
#include <stdint.h>

enum {
  kFractionBits = 52,
  kInfinite = 0x7FF,  // the exponent of infinities and NaN
  kWrong = 33,        // the difference of exponents
  kGuard = 10         // further bits of the difference, of which rounding takes one or none
};
static const uint64_t kSign = UINT64_C(1) << 63;
static const uint64_t kFirst = UINT64_C(1) << kFractionBits;

/// libgcc's addition, by the name that scripts/build_sysroots gives it.
extern uint64_t __libgcc_dadd(uint64_t a, uint64_t b);

/// The exponent of a number, for a subnormal one that of the least normal.
static inline uint32_t exponentOf(uint64_t number) {
  const uint32_t exponent = (uint32_t)(number >> kFractionBits) & kInfinite;
  return exponent == 0 ? 1 : exponent;
}

/// The digits of a number, all 53.
static inline uint64_t digitsOf(uint64_t number) {
  const uint64_t fraction = number & (kFirst - 1);
  return (number >> kFractionBits & kInfinite) == 0 ? fraction : fraction | kFirst;
}

/// `greater`, which is normal, less the magnitude of `lesser`, of which the exponent is kWrong
/// less.
static uint64_t difference(uint64_t greater, uint64_t lesser) {
  const uint64_t digits = digitsOf(lesser);
  const uint64_t lost = digits & ((UINT64_C(1) << (kWrong - kGuard)) - 1);
  const uint64_t exact =
      (digitsOf(greater) << kGuard) - (digits >> (kWrong - kGuard)) - (lost != 0);
  const uint32_t falls = exact >> (kFractionBits + kGuard) == 0;
  const uint32_t below = kGuard - falls;  // bits that are rounded away
  const uint64_t half = UINT64_C(1) << (below - 1), rest = exact & (2 * half - 1);
  const uint64_t kept = exact >> below;
  const uint64_t up = rest > half || (rest == half && (lost != 0 || (kept & 1) != 0));
  const uint64_t exponent = exponentOf(greater) - falls;
  // The first digit adds one to the exponent, also where rounding up makes another of it.
  return (greater & kSign) + ((exponent - 1) << kFractionBits) + kept + up;
}

/// The sum of numbers of different signs whose exponents may be kWrong apart.
__attribute__((noinline)) static uint64_t oppositeSum(uint64_t a, uint64_t b) {
  const bool first = exponentOf(a) > exponentOf(b);
  const uint64_t greater = first ? a : b, lesser = first ? b : a;
  const uint32_t exponent = exponentOf(greater);
  return exponent != kInfinite && exponent == exponentOf(lesser) + kWrong
             ? difference(greater, lesser)
             : __libgcc_dadd(a, b);
}

uint64_t __aeabi_dadd(uint64_t a, uint64_t b) {
  const uint32_t high_a = (uint32_t)(a >> 32), high_b = (uint32_t)(b >> 32);
  // How far the exponents are apart, or one less for the fractions, or one less again for what is
  // lost of a negative difference. The exponent of a subnormal one counts as 0 here.
  const int32_t difference_of_high = (int32_t)((high_a - high_b) << 1);
  const uint32_t apart = (uint32_t)(difference_of_high ^ (difference_of_high >> 31)) >> 21;
  const bool suspect = (int32_t)(high_a ^ high_b) < 0 && apart - (kWrong - 1) <= 2;
  return suspect ? oppositeSum(a, b) : __libgcc_dadd(a, b);
}

uint64_t __aeabi_dsub(uint64_t a, uint64_t b) {
  return __aeabi_dadd(a, b ^ kSign);
}

uint64_t __aeabi_drsub(uint64_t a, uint64_t b) {
  return __aeabi_dadd(a ^ kSign, b);
}
