// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Says the digest of sums and differences whose operands are up to 70 powers of two apart, which is
// the same on every board: routines for a processor without FPU must round as others do.

#include "runtime/board/arithmetic.h"

#include <bit>
#include <initializer_list>
#include <stdint.h>
#include <stdio.h>

namespace {

constexpr uint32_t kFarthest = 70, kSumsOfAKind = 400, kFractionBits = 52;
constexpr uint64_t kFraction = (uint64_t{1} << kFractionBits) - 1, kSign = uint64_t{1} << 63;

class Sums {
 public:
  [[nodiscard]] uint64_t digest() const { return digest_; }

  void add(uint64_t a, uint64_t b) {
    const volatile double first = std::bit_cast<double>(a), second = std::bit_cast<double>(b);
    note(first + second);
    note(second - first);
  }

  /// Operands with exponents `distance` apart; `kind`: any fractions, short ones of the greater, or
  /// powers of two less something, whose differences fall below them.
  void add(uint32_t distance, uint64_t sign, uint32_t kind) {
    const uint64_t exponent = kFarthest + 2 + random() % 1900, sign_of_first = random() & kSign;
    uint64_t fraction = random() & kFraction, other = random() & kFraction;
    fraction &= kind == 0 ? kFraction : kind == 1 ? random() % 8 : 0;
    other &= kind == 2 ? kFraction << random() % kFractionBits : kFraction;
    const uint64_t first = sign_of_first | exponent << kFractionBits | fraction;
    const uint64_t second = (sign_of_first ^ sign) | (exponent - distance) << kFractionBits | other;
    random() % 2 == 0 ? add(first, second) : add(second, first);
  }

 private:
  uint64_t random() {  // xorshift64
    state_ ^= state_ << 13U;
    state_ ^= state_ >> 7U;
    return state_ ^= state_ << 17U;
  }
  void note(double sum) { digest_ = (digest_ ^ std::bit_cast<uint64_t>(sum)) * 1099511628211; }

  uint64_t state_ = 88172645463325252, digest_ = 0;
};

}  // namespace

int main() {
  glider::runtime::useDoublePrecision();
  Sums sums;
  for (uint32_t distance = 0; distance <= kFarthest; ++distance) {
    for (uint32_t i = 0; i < 6 * kSumsOfAKind; ++i) {
      sums.add(distance, i % 2 == 0 ? 0 : kSign, i / 2 % 3);
    }
  }
  // Beside the least normal number, the greatest one, and infinity.
  constexpr uint64_t kInfinity = uint64_t{0x7FF} << kFractionBits;
  for (const uint64_t least : {uint64_t{1}, uint64_t{0x123456789}, uint64_t{0xC0000001},
                               uint64_t{0x80000001}, kFraction, kFraction + 1}) {
    for (const uint64_t exponent : {33U, 34U, 35U}) {
      sums.add(exponent << kFractionBits | kSign, least);
      sums.add(exponent << kFractionBits | 5, least | kSign);
    }
    sums.add(kInfinity | kSign, least);
  }
  sums.add(kInfinity - 1, (kInfinity - (uint64_t{33} << kFractionBits) - 1) | kSign);
  sums.add(kInfinity, (kInfinity - (uint64_t{33} << kFractionBits)) | kSign);
  printf("%llu\n", static_cast<unsigned long long>(sums.digest()));
  return 0;
}
