// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/recon/messages.h"

#include <stdint.h>

namespace glider::hooks::recon {

/// A line that is being written: its text, then end().
class LineWriter {
 public:
  /// Writes into `bytes`, of which there are `capacity`.
  LineWriter(char* bytes, uint32_t capacity) : bytes_(bytes), capacity_(capacity) {}

  LineWriter& put(char c);
  LineWriter& put(const char* text);
  /// Of the text of somebody else: one with what would end or begin a line is refused.
  LineWriter& put(const Text& text);
  /// With six decimals. One that is not finite is refused.
  LineWriter& put(double value);
  /// A comma, a prefix and a number; of an unknown one only the prefix.
  LineWriter& field(const char* prefix, double value);
  /// With as many digits as are asked for; those above are cut off.
  LineWriter& digits(uint32_t value, uint32_t count);
  LineWriter& whole(uint32_t value);
  /// Adds `before`, which has the `*`, the sum and the line feed. Returns the size of the whole; 0
  /// if it did not fit or something was refused.
  uint32_t end(const char* before = ",*");

 private:
  char* bytes_;
  uint32_t capacity_;
  uint32_t size_ = 0;
  uint8_t sum_ = 0;
  bool refused_ = false;
};

}  // namespace glider::hooks::recon
