// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <stdint.h>

namespace glider::hooks::extctl {

/// `index:value`, as reports and what the SBC writes have them.
struct Pair {
  bool good = false;   ///< false: it is not a pair, and the rest has no meaning
  uint32_t index = 0;  ///< may be that of no sensor
  double value = 0;
};

/// Goes through the pairs after the name of a sentence, which commas separate. No heap.
class PairReader {
 public:
  /// `text`, of which there are `size` characters, outlives this.
  PairReader(const char* text, uint32_t size) : text_(text), size_(size) {}

  /// Takes the next pair that is not empty; false at the end.
  [[nodiscard]] bool next(Pair* pair);

 private:
  const char* text_;
  uint32_t size_;
  uint32_t at_ = 0;
};

}  // namespace glider::hooks::extctl
