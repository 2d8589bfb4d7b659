// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <stdint.h>

namespace glider::hooks {

/// Characters without a zero at the end, which are somebody else's: of a message that was read they
/// are in what it was read from; what is to be written stays where it is until then.
struct Text {
  const char* bytes = nullptr;
  uint32_t size = 0;

  friend constexpr bool operator==(const Text& one, const Text& other) {
    bool same = one.size == other.size;
    for (uint32_t i = 0; same && i < one.size; ++i) {
      same = one.bytes[i] == other.bytes[i];
    }
    return same;
  }
};

/// A text that a zero ends, without it.
constexpr Text textOf(const char* text) {
  Text found{text, 0};
  while (text[found.size] != '\0') {
    ++found.size;
  }
  return found;
}

}  // namespace glider::hooks
