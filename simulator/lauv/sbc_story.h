// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/imc/packet.h"
#include "hooks/seat/events.h"
#include "hooks/seat/seat.h"

#include <deque>
#include <string_view>

namespace glider::simulator::lauv {

/// What the SBC says of its mission, in entries of the vehicle's log (hooks/imc/README.md).
class SbcStory {
 public:
  /// Takes a packet of the SBC.
  void take(const hooks::imc::Packet& packet, double now_s);
  /// Without a message for a while, nothing is known of its mission.
  void look(double now_s);

  hooks::SeatEvent nextEvent();
  [[nodiscard]] const hooks::SbcView& view() const { return view_; }

 private:
  void takeText(std::string_view text);

  std::deque<hooks::SeatEvent> events_;
  hooks::SbcView view_;
  double heard_s_ = 0;
};

}  // namespace glider::simulator::lauv
