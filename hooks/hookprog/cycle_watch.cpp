// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/hookprog/cycle_watch.h"

namespace glider::hooks {

bool CycleWatch::isNext(uint32_t cycle) {
  constexpr uint32_t kCircle = 0xFFFFFF;
  constexpr uint32_t kMostLost = 8;  // lost reports between two that arrive in order
  const uint32_t ahead = (cycle - newest_) & kCircle;
  const uint32_t after_earlier = (cycle - earlier_) & kCircle;
  const bool later = ahead != 0 && ahead <= kCircle / 2;
  const bool restarted = was_earlier_ && after_earlier != 0 && after_earlier <= kMostLost;
  was_earlier_ = known_ && !later && !restarted;
  earlier_ = cycle;
  newest_ = was_earlier_ ? newest_ : cycle;
  known_ = true;
  return !was_earlier_;
}

}  // namespace glider::hooks
