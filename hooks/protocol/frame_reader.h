// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/protocol/frame.h"
#include "hooks/transport/byte_stream.h"

#include <stdint.h>

namespace glider::hooks {

/// Splits a stream into whole frames, one at a time; bytes after a frame wait for the next call.
class FrameReader {
 public:
  enum class Result : uint8_t { Nothing, Frame, Closed };

  /// The next whole frame, if all its bytes have arrived. Reads at most `kMostBytes`, so that a
  /// stream full of noise cannot block its reader. Closed: the other end is gone and everything it
  /// sent has been read.
  Result next(const GliderByteStream& stream) {
    for (uint32_t looked = 0; looked < kMostBytes; ++looked) {
      if (at_ >= count_) {
        const int32_t got = stream.read(stream.self, bytes_, sizeof bytes_);
        if (got <= 0) {
          return got < 0 ? Result::Closed : Result::Nothing;
        }
        at_ = 0;
        count_ =
            static_cast<uint32_t>(got) < sizeof bytes_ ? static_cast<uint32_t>(got) : sizeof bytes_;
      }
      if (decoder_.push(bytes_[at_++])) {
        return Result::Frame;
      }
    }
    return Result::Nothing;
  }

  [[nodiscard]] const Frame& frame() const { return decoder_.frame(); }
  [[nodiscard]] uint32_t badFrames() const { return decoder_.badFrames(); }
  /// How many bytes it holds: at most kBytes, unless its memory is broken.
  [[nodiscard]] uint32_t held() const { return count_; }
  static constexpr uint32_t kBytes = 256;

 private:
  static constexpr uint32_t kMostBytes = 8192;

  FrameDecoder decoder_;
  uint8_t bytes_[kBytes] = {};
  uint32_t at_ = 0;
  uint32_t count_ = 0;
};

}  // namespace glider::hooks
