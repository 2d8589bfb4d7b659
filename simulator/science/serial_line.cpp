// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/science/serial_line.h"

#include <algorithm>

namespace glider::simulator {

int32_t SerialLine::read(void* self, uint8_t* bytes, uint32_t capacity) {
  const End& end = *static_cast<End*>(self);
  auto& queue = end.in->bytes;
  uint32_t count = 0;
  while (count < capacity && !queue.empty() && queue.front().arrives_s <= end.line->now_s_) {
    bytes[count++] = queue.front().value;
    queue.pop_front();
  }
  return static_cast<int32_t>(count);
}

int32_t SerialLine::write(void* self, const uint8_t* bytes, uint32_t count) {
  const End& end = *static_cast<End*>(self);
  Direction& out = *end.out;
  const auto room = static_cast<uint32_t>(kCapacity - out.bytes.size());
  const uint32_t taken = std::min(count, room);
  out.free_s = std::max(out.free_s, end.line->now_s_);
  for (uint32_t i = 0; i < taken; ++i) {
    out.free_s += end.line->byte_time_s_;
    out.bytes.push_back({bytes[i], out.free_s});
  }
  return static_cast<int32_t>(taken);
}

}  // namespace glider::simulator
