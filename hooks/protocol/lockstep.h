// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/protocol/frame.h"

#include <stdint.h>

namespace glider::hooks {

/// Monitors the line between vehicle and SBC and detects when the SBC has finished its answer: in
/// virtual time the vehicle's clock waits for that. Pass it the bytes as they arrive at each end.
class Lockstep {
 public:
  void toSbc(const uint8_t* bytes, uint32_t count);
  void fromSbc(const uint8_t* bytes, uint32_t count);
  /// True when the newest whole frame that expects an answer has its Done.
  [[nodiscard]] bool settled() const { return !owed_; }

 private:
  FrameDecoder to_sbc_;
  FrameDecoder from_sbc_;
  bool owed_ = false;
  uint8_t owed_sequence_ = 0;
};

}  // namespace glider::hooks
