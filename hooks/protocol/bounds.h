// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <stdint.h>

/// Checks of memory that nothing on the line can break: counters and enumerations that are past
/// their limits only after a fault of the memory or of the program.
namespace glider::hooks {

/// A number in an object and the greatest value that it can have.
struct Bound {
  uint16_t offset;  ///< in the object
  uint16_t most : 12;
  uint16_t bytes : 4;  ///< 1 or 4
};

/// The index of the first number of `object` that is past its bound; `count` if there is none.
inline uint32_t firstPast(const void* object, const Bound* bounds, uint32_t count) {
  const auto* bytes = static_cast<const uint8_t*>(object);
  for (uint32_t i = 0; i < count; ++i) {
    const uint8_t* number = bytes + bounds[i].offset;
    const uint32_t value =
        bounds[i].bytes == 1 ? *number : *reinterpret_cast<const uint32_t*>(number);
    if (value > bounds[i].most) {
      return i;
    }
  }
  return count;
}

template <uint32_t kCount>
uint32_t firstPast(const void* object, const Bound (&bounds)[kCount]) {
  return firstPast(object, bounds, kCount);
}

}  // namespace glider::hooks
