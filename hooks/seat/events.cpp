// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/seat/events.h"

namespace glider::hooks {

void EventQueue::push(const SeatEvent& event) {
  const bool note = event.kind == SeatEvent::Kind::SbcNote;
  if (count_ < (note ? kMost - kRoomBesideNotes : kMost)) {
    events_[(first_ + count_) % kMost] = event;
    ++count_;
  }
}

SeatEvent EventQueue::next() {
  if (count_ == 0) {
    return {};
  }
  const SeatEvent oldest = events_[first_];
  first_ = (first_ + 1) % kMost;
  --count_;
  return oldest;
}

}  // namespace glider::hooks
