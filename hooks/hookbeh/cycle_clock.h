// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

namespace glider::hooks {

/// How long each control cycle took. Two clocks and the cycle number are held against each other,
/// so that one false reading of any of them changes nothing.
class CycleClock {
 public:
  /// Takes in one cycle: m_present_secs_into_mission, m_present_time, m_cycle_number; NaN for
  /// unknown.
  void advance(double mission_s, double wall_s, double cycle);
  /// Since the cycle before, s; above 0 and at most 20, whatever the clocks say: timers must run
  /// out even where time stands still.
  [[nodiscard]] double step() const { return step_s_; }
  /// The mission's time of this cycle follows on that of the cycle before.
  [[nodiscard]] bool follows() const { return follows_; }

 private:
  double mission_s_ = __builtin_nan("");
  double wall_s_ = __builtin_nan("");
  double cycle_ = __builtin_nan("");
  double step_s_ = 0;
  bool follows_ = false;
};

}  // namespace glider::hooks
