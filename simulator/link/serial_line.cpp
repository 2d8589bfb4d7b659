// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/link/serial_line.h"

#include <algorithm>

namespace glider::simulator {

int32_t SerialLine::read(void* self, uint8_t* bytes, uint32_t capacity) {
  const End& end = *static_cast<End*>(self);
  auto& queue = end.in->bytes;
  uint32_t count = 0;
  while (count < capacity && !queue.empty() && queue.front().at_s <= end.line->now_s_) {
    bytes[count++] = queue.front().value;
    queue.pop_front();
  }
  return static_cast<int32_t>(count);
}

int32_t SerialLine::write(void* self, const uint8_t* bytes, uint32_t count) {
  const End& end = *static_cast<End*>(self);
  Direction& out = *end.out;
  const double now = end.line->now_s_;
  out.free_s = std::max(out.free_s, now);
  uint32_t taken = 0;
  for (; taken < count && out.bytes.size() < kCapacity; ++taken) {
    out.free_s += end.line->byte_time_s_;
    out.free_s += out.damage.pass(bytes[taken], now, out.free_s, out.bytes);
  }
  return static_cast<int32_t>(taken);
}

void SerialLine::drop(End& end) {
  end.in->bytes.clear();
  auto& sent = end.out->bytes;
  while (!sent.empty() && sent.back().at_s > now_s_) {
    sent.pop_back();
  }
  end.out->free_s = now_s_;
}

}  // namespace glider::simulator
