// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/transport/byte_stream.h"

#include <stdint.h>

namespace glider::hooks {

/// A line in memory with two ends: what one end writes the other reads. For one thread. Its ends
/// point into it: it must not move while they are in use.
class MemoryLine {
 public:
  static constexpr uint32_t kCapacity = 4096;  ///< bytes in transit in each direction

  MemoryLine() { setEnds(); }
  MemoryLine(const MemoryLine&) = delete;
  MemoryLine& operator=(const MemoryLine&) = delete;

  [[nodiscard]] GliderByteStream left();
  [[nodiscard]] GliderByteStream right();
  /// Cuts the line: bytes in transit can still be read, then both ends report that it is closed.
  void close() { closed_ = true; }

 private:
  struct Ring {
    uint8_t bytes[kCapacity] = {};
    uint32_t first = 0;
    uint32_t count = 0;
  };
  struct End {
    MemoryLine* line = nullptr;
    Ring* in = nullptr;
    Ring* out = nullptr;
  };
  static int32_t read(void* self, uint8_t* bytes, uint32_t capacity);
  static int32_t write(void* self, const uint8_t* bytes, uint32_t count);
  void setEnds();

  Ring to_right_;
  Ring to_left_;
  End left_;
  End right_;
  bool closed_ = false;
};

}  // namespace glider::hooks
