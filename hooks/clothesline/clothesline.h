// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/transport/byte_stream.h"

#include <stdint.h>

/// The 9600-baud line between flight controller and science computer, one object at each end:
/// carries sensor updates as frames of the hook protocol.
namespace glider::hooks {

struct SensorUpdate {
  uint16_t id = 0;
  double value = 0;
};

class Clothesline {
 public:
  static constexpr uint32_t kMostUpdates = 128;
  /// Queues `count` updates to go in order (a sequence sensor goes last); false when the queue has
  /// no room for all.
  bool send(const SensorUpdate* updates, uint32_t count);
  /// Writes what the stream takes of the queue, reads what is there; fills `updates` with at most
  /// `capacity` that came in whole, checked frames. Returns their number.
  uint32_t poll(const GliderByteStream& stream, SensorUpdate* updates, uint32_t capacity);
};

}  // namespace glider::hooks
