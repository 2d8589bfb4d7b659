// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/protocol/frame.h"
#include "hooks/transport/byte_stream.h"

#include <stdint.h>

namespace glider::hooks {

/// Encoded frames on their way to a stream that may take only a part at a time. Whole frames go in
/// or none.
template <uint32_t kCapacity>
class SendQueue {
 public:
  /// False, with nothing queued, when there is no room for `frame`.
  bool add(const Frame& frame) {
    if (kCapacity - end_ < encodedBound(frame.size)) {
      return false;
    }
    end_ += encodeFrame(frame, bytes_ + end_);
    return true;
  }

  /// Hands over what `stream` takes. False when the stream is closed or failed.
  bool flush(const GliderByteStream& stream) {
    while (next_ < end_) {
      const int32_t taken = stream.write(stream.self, bytes_ + next_, end_ - next_);
      if (taken < 0) {
        return false;
      }
      if (taken == 0) {
        break;
      }
      next_ +=
          static_cast<uint32_t>(taken) < end_ - next_ ? static_cast<uint32_t>(taken) : end_ - next_;
    }
    moveDown();
    return true;
  }

  [[nodiscard]] uint32_t room() const { return kCapacity - end_; }
  [[nodiscard]] bool empty() const { return next_ == end_; }

 private:
  void moveDown() {
    for (uint32_t i = next_; i < end_; ++i) {
      bytes_[i - next_] = bytes_[i];
    }
    end_ -= next_;
    next_ = 0;
  }

  uint8_t bytes_[kCapacity] = {};
  uint32_t next_ = 0;
  uint32_t end_ = 0;
};

}  // namespace glider::hooks
