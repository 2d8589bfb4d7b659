// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

namespace glider::hooks {

/// Measures how long each control cycle took. Two clocks and the cycle number are compared with
/// each other, so that one false reading of any of them has no effect.
class CycleClock {
 public:
  /// Takes in one cycle: m_present_secs_into_mission, m_present_time, m_cycle_number; NaN for
  /// unknown.
  void advance(double mission_s, double wall_s, double cycle);
  /// Time since the previous cycle, s; above 0 and at most 20 for any readings of the clocks:
  /// timers must expire even if the clocks do not advance.
  [[nodiscard]] double step() const { return step_s_; }
  /// True if the mission time of this cycle continues that of the previous cycle.
  [[nodiscard]] bool follows() const { return follows_; }

 private:
  double mission_s_ = __builtin_nan("");
  double wall_s_ = __builtin_nan("");
  double cycle_ = __builtin_nan("");
  double step_s_ = 0;
  bool follows_ = false;
};

}  // namespace glider::hooks
