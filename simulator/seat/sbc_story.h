// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/seat/events.h"
#include "hooks/seat/seat.h"

#include <deque>
#include <string_view>

namespace glider::simulator {

/// What an SBC says of its mission to a vehicle that has no hooks: texts of runtime/front_seat.
class SbcStory {
 public:
  /// Takes a text.
  void take(std::string_view text);
  /// The SBC is there.
  void heard(double now_s) { heard_s_ = now_s; }
  /// Without a message for a while, nothing is known of its mission.
  void look(double now_s);

  hooks::SeatEvent nextEvent();
  [[nodiscard]] const hooks::SbcView& view() const { return view_; }

 private:
  std::deque<hooks::SeatEvent> events_;
  hooks::SbcView view_;
  double heard_s_ = 0;
};

}  // namespace glider::simulator
