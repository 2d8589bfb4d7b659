// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/protocol/frame_reader.h"
#include "hooks/protocol/sensor_list.h"
#include "hooks/transport/byte_stream.h"

#include <stdint.h>

/// The 9600-baud line between flight controller and science computer, one object at each end:
/// carries sensor updates as frames of the hook protocol.
namespace glider::hooks {

using SensorUpdate = SensorValue;

class FlightScienceLink {
 public:
  static constexpr uint32_t kMostUpdates = 128;
  /// `dictionary` outlives this; both ends have the same.
  explicit FlightScienceLink(const GliderDictionary& dictionary) : dictionary_(&dictionary) {}
  /// Queues `count` updates to go in order (a sequence sensor goes last); false, with nothing
  /// queued, when there is no room for all of them or one id is not a sensor. The updates of one
  /// call go in one frame if they fit, so that they arrive together or not at all.
  bool send(const SensorUpdate* updates, uint32_t count);
  /// Writes as much of the queue as the stream accepts, and reads what is available; fills
  /// `updates` with at most `capacity` updates that arrived in complete, checked frames. Returns
  /// their number: call again while it equals `capacity`.
  uint32_t poll(const GliderByteStream& stream, SensorUpdate* updates, uint32_t capacity);
  /// Frames discarded since the start, for logs.
  [[nodiscard]] uint32_t badFrames() const { return reader_.badFrames() + malformed_; }

 private:
  struct Queued {
    SensorUpdate update;
    bool starts_group = false;
  };
  void flush(const GliderByteStream& stream);
  /// Moves the next group of the queue, or as much of it as one frame holds, into `out_`.
  void encodeNext();
  [[nodiscard]] const Queued& queued(uint32_t index) const {
    return queue_[(first_ + index) % kMostUpdates];
  }

  const GliderDictionary* dictionary_;
  Queued queue_[kMostUpdates];
  uint32_t first_ = 0;
  uint32_t count_ = 0;
  uint8_t out_[kMostEncodedBytes] = {};
  uint32_t out_next_ = 0;
  uint32_t out_end_ = 0;
  uint8_t sequence_ = 0;
  FrameReader reader_;
  SensorList received_;
  uint32_t received_next_ = 0;
  uint32_t malformed_ = 0;
};

}  // namespace glider::hooks
