// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/protocol/frame.h"
#include "hooks/transport/byte_stream.h"

#include <stdint.h>

namespace glider::hooks {

/// Encoded frames on their way to a stream that may accept only a part at a time. Frames are queued
/// whole or not at all.
class SendQueue {
 public:
  static constexpr uint32_t kCapacity = 2048;  ///< bytes

  /// False, with nothing queued, when there is no room for `frame`.
  bool add(const Frame& frame);
  /// Writes as much as `stream` accepts. False when the stream is closed or failed.
  bool flush(const GliderByteStream& stream);
  [[nodiscard]] uint32_t room() const;
  [[nodiscard]] bool empty() const;
  /// How many bytes wait: at most kCapacity, unless its memory is broken.
  [[nodiscard]] uint32_t held() const { return end_; }

 private:
  void takeAway(uint32_t count);

  uint8_t bytes_[kCapacity] = {};
  uint32_t end_ = 0;
};

}  // namespace glider::hooks
