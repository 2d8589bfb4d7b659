// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <stdint.h>

namespace glider::hooks::share {

/// A whole number from 0 on, of at most kMostBytes bytes, that is made from digits of different
/// bases and taken apart into them again. No heap.
class Number {
 public:
  static constexpr uint32_t kMostBytes = 32;

  Number() = default;
  /// From bytes, the least significant first; at most kMostBytes of them count.
  Number(const uint8_t* bytes, uint32_t count);

  /// Becomes itself times `base` plus `digit`, which is below `base`. False if that needs more
  /// bytes; then it is of no use any more.
  bool put(uint32_t base, uint32_t digit);
  /// Returns the last digit in `base`, at least 1, and loses it.
  uint32_t take(uint32_t base);

  /// The least significant first.
  [[nodiscard]] uint8_t byte(uint32_t index) const { return bytes_[index]; }
  /// Without leading zeros: of the number 0 none.
  [[nodiscard]] uint32_t bits() const;
  [[nodiscard]] uint32_t size() const { return (bits() + 7) / 8; }

 private:
  uint8_t bytes_[kMostBytes] = {};
};

}  // namespace glider::hooks::share
