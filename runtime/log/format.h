// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <stdint.h>

/// Text without a printf, into bounded memory, the same on every board.
namespace glider::runtime {

/// Room that formatNumber needs.
inline constexpr uint32_t kNumberBytes = 24;

/// Writes `value` with at most 12 significant digits, no trailing zeros, with an exponent outside
/// 1e-5…1e15; nothing for NaN. Returns the number of bytes; no terminating zero.
uint32_t formatNumber(double value, char* out);
/// Writes `value` in decimal. Returns the number of bytes.
uint32_t formatCount(uint32_t value, char* out);

/// A text under construction. What does not fit is cut off, and full() reports that.
class Text {
 public:
  Text(char* bytes, uint32_t capacity) : bytes_(bytes), capacity_(capacity) {}
  Text& put(char c);
  /// At most `most` characters of `text`, up to its terminating zero.
  Text& put(const char* text, uint32_t most = UINT32_MAX);
  Text& put(double value);
  Text& putCount(uint32_t value);
  [[nodiscard]] const char* bytes() const { return bytes_; }
  [[nodiscard]] uint32_t size() const { return size_; }
  [[nodiscard]] bool full() const { return full_; }

 private:
  char* bytes_;
  uint32_t capacity_;
  uint32_t size_ = 0;
  bool full_ = false;
};

}  // namespace glider::runtime
