// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/protocol/frame_reader.h"
#include "hooks/protocol/messages.h"
#include "hooks/protocol/sensor_list.h"
#include "hooks/protocol/tick.h"
#include "hooks/transport/clock.h"
#include "hooks/transport/memory.h"
#include "tests/slocum.h"

#include <vector>

namespace glider::hooks {

/// All whole frames that wait at an end of a line.
inline std::vector<Frame> framesAt(const GliderByteStream& stream) {
  FrameReader reader;
  std::vector<Frame> frames;
  while (reader.next(stream) == FrameReader::Result::Frame) {
    frames.push_back(reader.frame());
  }
  return frames;
}

inline std::vector<MessageType> typesOf(const std::vector<Frame>& frames) {
  std::vector<MessageType> types;
  for (const Frame& frame : frames) {
    types.push_back(frame.type);
  }
  return types;
}

inline void put(const GliderByteStream& stream, const Frame& frame) {
  uint8_t bytes[kMostEncodedBytes];
  const uint32_t size = encodeFrame(frame, bytes);
  stream.write(stream.self, bytes, size);
}

template <typename Message>
void putMessage(const GliderByteStream& stream, const Message& message, uint8_t sequence = 1) {
  Frame frame;
  encode(message, frame);
  frame.sequence = sequence;
  put(stream, frame);
}

/// A clock that the test sets.
struct HandClock {
  double seconds = 0;
  GliderClock clock() {
    return {this, [](void* self) { return static_cast<HandClock*>(self)->seconds; }};
  }
};

}  // namespace glider::hooks
