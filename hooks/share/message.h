// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/share/number.h"

#include <stdint.h>

/// The messages by which the vehicles of a fleet tell each other values (README.md). Both ends know
/// the scales of a message; only numbers of them cross the water. No heap.
namespace glider::hooks::share {

/// The values of a share: `lowest` + i `step`, 0 <= i < `values`.
struct Scale {
  double lowest = 0;
  double step = 1;      ///< positive
  uint32_t values = 1;  ///< below UINT32_MAX
};

/// The number of the value nearest to `value`, from 1 on; 0 for one that is unknown (NaN) or
/// outside of the scale by half a step or more. A value in the middle goes up.
uint32_t digitOf(const Scale& scale, double value);

/// The value with this number, at most `values`; NaN for 0.
double valueOf(const Scale& scale, uint32_t digit);

/// The room that a message needs.
struct MessageSize {
  uint32_t bytes = 0;  ///< 0: more than Number::kMostBytes
  uint32_t bits = 0;   ///< the least with which its values can be distinguished, with the signature
  uint32_t mini_bits = 0;  ///< as a mini packet; 0: more than kMiniBits
};

/// A mini packet of a modem holds so many bits.
inline constexpr uint32_t kMiniBits = 13;

MessageSize sizeOf(const Scale* scales, uint32_t count);

/// Writes a message: its shares from the last to the first, then end().
class MessageWriter {
 public:
  MessageWriter& put(const Scale& scale, double value);
  /// Writes `size` bytes, as sizeOf counts them. False if the message needs more, or if no message
  /// has so many; then nothing is written.
  bool end(uint8_t signature, uint8_t* bytes, uint32_t size);
  /// The same for a mini packet: its bits.
  bool endMini(uint8_t signature, uint32_t& bits);

 private:
  Number number_;
  bool fits_ = true;
};

/// Reads a message: its shares from the first to the last, then end().
class MessageReader {
 public:
  MessageReader(const uint8_t* bytes, uint32_t size) : number_(bytes, size), size_(size) {
    signature_ = number_.take(kSignatures);
  }
  /// The same of a mini packet.
  explicit MessageReader(uint32_t mini_bits);
  /// NaN for one that the sender did not know.
  double take(const Scale& scale) { return valueOf(scale, number_.take(scale.values + 1)); }
  /// Whether it is a message with this signature and size, and with no more than these shares. If
  /// not, what was taken from it means nothing.
  [[nodiscard]] bool end(uint8_t signature, uint32_t size) const {
    return signature_ == signature && size_ == size && number_.bits() == 0;
  }
  /// The same for a mini packet.
  [[nodiscard]] bool endMini(uint8_t signature) const {
    return signature_ == signature % kMiniSignatures && size_ == 0 && number_.bits() == 0;
  }

  static constexpr uint32_t kSignatures = 256;
  static constexpr uint32_t kMiniSignatures = 8;

 private:
  Number number_;
  uint32_t size_;
  uint32_t signature_ = 0;
};

}  // namespace glider::hooks::share
