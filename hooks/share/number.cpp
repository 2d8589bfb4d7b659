// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/share/number.h"

namespace glider::hooks::share {

Number::Number(const uint8_t* bytes, uint32_t count) {
  for (uint32_t i = 0; i < count && i < kMostBytes; ++i) {
    bytes_[i] = bytes[i];
  }
}

bool Number::put(uint32_t base, uint32_t digit) {
  uint64_t carry = digit;
  for (uint8_t& byte : bytes_) {
    carry += uint64_t{byte} * base;
    byte = static_cast<uint8_t>(carry & 0xFFU);
    carry >>= 8;
  }
  return carry == 0;
}

uint32_t Number::take(uint32_t base) {
  uint64_t rest = 0;
  for (uint32_t i = kMostBytes; i != 0; --i) {
    rest = (rest << 8) + bytes_[i - 1];
    bytes_[i - 1] = static_cast<uint8_t>(rest / base);  // rest was below base: one byte
    rest %= base;
  }
  return static_cast<uint32_t>(rest);
}

uint32_t Number::bits() const {
  uint32_t count = kMostBytes * 8;
  while (count != 0 && (bytes_[(count - 1) / 8] >> ((count - 1) % 8)) == 0) {
    --count;
  }
  return count;
}

}  // namespace glider::hooks::share
