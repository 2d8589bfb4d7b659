// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/transport/memory.h"

namespace glider::hooks {

void MemoryLine::setEnds() {
  left_ = {this, &to_left_, &to_right_};
  right_ = {this, &to_right_, &to_left_};
}

GliderByteStream MemoryLine::left() {
  return {&left_, &MemoryLine::read, &MemoryLine::write};
}

GliderByteStream MemoryLine::right() {
  return {&right_, &MemoryLine::read, &MemoryLine::write};
}

int32_t MemoryLine::read(void* self, uint8_t* bytes, uint32_t capacity) {
  const End& end = *static_cast<const End*>(self);
  Ring& ring = *end.in;
  if (ring.count == 0) {
    return end.line->closed_ ? kGliderStreamClosed : 0;
  }
  uint32_t n = 0;
  while (n < capacity && ring.count > 0) {
    bytes[n++] = ring.bytes[ring.first];
    ring.first = (ring.first + 1) % kCapacity;
    --ring.count;
  }
  return static_cast<int32_t>(n);
}

int32_t MemoryLine::write(void* self, const uint8_t* bytes, uint32_t count) {
  const End& end = *static_cast<const End*>(self);
  if (end.line->closed_) {
    return kGliderStreamClosed;
  }
  Ring& ring = *end.out;
  uint32_t n = 0;
  while (n < count && ring.count < kCapacity) {
    ring.bytes[(ring.first + ring.count) % kCapacity] = bytes[n++];
    ++ring.count;
  }
  return static_cast<int32_t>(n);
}

}  // namespace glider::hooks
