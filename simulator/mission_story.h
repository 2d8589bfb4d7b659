// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/seat/seat.h"
#include "platforms/load/platform.h"
#include "simulator/guard_text.h"
#include "simulator/journal.h"
#include "simulator/seat/simulated_seat.h"

#include <limits>
#include <string>
#include <vector>

namespace glider::simulator {

/// Follows the SBC's mission through what the seat receives from it: which state, since when, and
/// why it changed.
class MissionStory {
 public:
  MissionStory(const platforms::Platform& platform, const std::vector<std::string>& state_names,
               const GuardResolver& explain)
      : platform_(platform), state_names_(state_names), explain_(explain) {}

  /// After the seat has served it: writes the seat's events to `journal`. `cycle_s` is the time of
  /// the newest control cycle. Returns true if the mission has gone to another state.
  bool follow(double now_s, double cycle_s, SimulatedSeat& seat, Journal& journal);

  /// True while the mission is known to be in control.
  [[nodiscard]] bool flying() const { return flying_; }
  /// Mission time in the control cycle at `time_s`.
  [[nodiscard]] double missionTime(double time_s) const { return time_s - origin_s_; }
  [[nodiscard]] uint32_t state() const { return state_; }
  [[nodiscard]] std::string stateName(uint32_t state) const;

 private:
  void learnOrigin(double cycle_s, const hooks::SbcView& view, bool in_control);
  void transition(double now_s, const hooks::SeatEvent& event, const SimulatedSeat& seat,
                  Journal& journal) const;
  void note(double now_s, const hooks::SeatEvent& event, Journal& journal) const;
  [[nodiscard]] std::string why(const hooks::SeatEvent& event, const SimulatedSeat& seat) const;

  const platforms::Platform& platform_;
  const std::vector<std::string>& state_names_;
  const GuardResolver& explain_;
  bool flying_ = false;
  uint32_t state_ = 0;
  double origin_s_ = std::numeric_limits<double>::infinity();  ///< vehicle time at mission time 0
};

}  // namespace glider::simulator
