// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/flight_science_link/flight_science_link.h"

namespace glider::hooks {

bool FlightScienceLink::send(const SensorUpdate* updates, uint32_t count) {
  if (count > kMostUpdates - count_) {
    return false;
  }
  for (uint32_t i = 0; i < count; ++i) {
    if (sensorWidth(*dictionary_, updates[i].id) == 0) {
      return false;
    }
  }
  for (uint32_t i = 0; i < count; ++i) {
    queue_[(first_ + count_) % kMostUpdates] = {updates[i], i == 0};
    ++count_;
  }
  return true;
}

uint32_t FlightScienceLink::poll(const GliderByteStream& stream, SensorUpdate* updates,
                                 uint32_t capacity) {
  flush(stream);
  uint32_t given = 0;
  while (given < capacity) {
    if (received_next_ < received_.count) {
      updates[given++] = received_.values[received_next_++];
      continue;
    }
    if (reader_.next(stream) != FrameReader::Result::Frame) {
      break;
    }
    received_next_ = 0;
    if (reader_.frame().type != MessageType::Sensors ||
        !decodeList(*dictionary_, reader_.frame(), received_)) {
      received_.count = 0;
      ++malformed_;
    }
  }
  return given;
}

void FlightScienceLink::flush(const GliderByteStream& stream) {
  while (out_next_ < out_end_ || count_ > 0) {
    if (out_next_ == out_end_) {
      encodeNext();
    }
    const int32_t taken = stream.write(stream.self, out_ + out_next_, out_end_ - out_next_);
    if (taken <= 0) {
      return;
    }
    out_next_ += static_cast<uint32_t>(taken);
  }
}

void FlightScienceLink::encodeNext() {
  Frame frame;
  encodeEmptyList(MessageType::Sensors, frame);
  frame.sequence = ++sequence_;
  do {
    if (!appendValue(*dictionary_, frame, queued(0).update)) {
      break;  // full: the rest of the group goes in the next frame
    }
    first_ = (first_ + 1) % kMostUpdates;
    --count_;
  } while (count_ > 0 && !queued(0).starts_group);
  out_end_ = encodeFrame(frame, out_);
  out_next_ = 0;
}

}  // namespace glider::hooks
