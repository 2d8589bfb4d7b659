// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/protocol/lockstep.h"

#include "hooks/protocol/messages.h"

namespace glider::hooks {

void Lockstep::toSbc(const uint8_t* bytes, uint32_t count) {
  for (uint32_t i = 0; i < count; ++i) {
    if (to_sbc_.push(bytes[i]) && expectsAnswer(to_sbc_.frame())) {
      owed_ = true;
      owed_sequence_ = to_sbc_.frame().sequence;
    }
  }
}

void Lockstep::fromSbc(const uint8_t* bytes, uint32_t count) {
  for (uint32_t i = 0; i < count; ++i) {
    Done done;
    if (from_sbc_.push(bytes[i]) && decode(from_sbc_.frame(), done) &&
        done.answered == owed_sequence_) {
      owed_ = false;
    }
  }
}

}  // namespace glider::hooks
