// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/protocol/send_queue.h"

namespace glider::hooks {

uint32_t SendQueue::room() const {
  return kCapacity - end_;
}

bool SendQueue::empty() const {
  return end_ == 0;
}

bool SendQueue::add(const Frame& frame) {
  if (room() < encodedBound(frame.size)) {
    return false;
  }
  end_ += encodeFrame(frame, bytes_ + end_);
  return true;
}

bool SendQueue::flush(const GliderByteStream& stream) {
  uint32_t next = 0;
  int32_t taken = 1;
  while (next < end_ && taken > 0) {
    taken = stream.write(stream.self, bytes_ + next, end_ - next);
    next += taken > 0 ? static_cast<uint32_t>(taken) : 0;
  }
  takeAway(next);
  return taken >= 0;
}

/// Removes the first `count` bytes; all of them if a stream claims to have taken more than there
/// were.
void SendQueue::takeAway(uint32_t count) {
  const uint32_t rest = count < end_ ? end_ - count : 0;
  for (uint32_t i = 0; i < rest; ++i) {
    bytes_[i] = bytes_[count + i];
  }
  end_ = rest;
}

}  // namespace glider::hooks
