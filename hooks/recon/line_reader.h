// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <stdint.h>

/// Lines of RECON: `#TEXT*HH` and a line feed, each in a datagram of its own. HH is the sum of all
/// bytes from `#` to `*`, modulo 256, in upper-case hexadecimal digits.
namespace glider::hooks::recon {

/// The longest line, with its line feed.
inline constexpr uint32_t kMostLine = 1024;

/// A line whose sum is right: from its `#` to what comes before its `*`.
struct Line {
  const char* text = nullptr;
  uint32_t size = 0;
};

/// Finds the lines in what arrives (README.md, rules R1 to R4). No heap; the work for each byte is
/// bounded.
class LineReader {
 public:
  /// Takes one byte. True when it ends a line whose sum is right: `line` is valid until the next
  /// push.
  [[nodiscard]] bool push(uint8_t byte, Line* line);

  /// Bytes that belong to no line. With those of the lines and those that are held they are all
  /// that was pushed.
  [[nodiscard]] uint32_t skippedBytes() const { return skipped_bytes_; }
  /// Bytes that may still become part of a line.
  [[nodiscard]] uint32_t held() const { return size_; }

 private:
  bool end(Line* line);

  char bytes_[kMostLine] = {};
  uint32_t size_ = 0;
  bool too_long_ = false;  ///< what arrives is skipped up to the next line feed
  uint32_t skipped_bytes_ = 0;
};

}  // namespace glider::hooks::recon
