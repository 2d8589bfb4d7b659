// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "vehicles/slocum/oracles/judge_setup.h"
#include "vehicles/slocum/oracles/names.h"

#include <string>

namespace glider::slocum::oracles {

/// Checks hookbeh's guards by the sensor array and the true state, while no depth limit is broken
/// yet: a missing guard may be covered by another, and the vehicle then has one guard less than it
/// should.
class GuardJudge {
 public:
  explicit GuardJudge(const JudgeSetup& setup);

  /// What is violated in this cycle; empty: nothing.
  std::string cycle(const CycleView& view);
  /// A new hookbeh begins.
  void restart();

 private:
  std::string judgePump(const CycleView& view) const;
  std::string judgeJump(const CycleView& view);
  std::string judgeClimb(const CycleView& view);
  std::string judgeOverridden(const CycleView& view);
  std::string judgeMasked(const CycleView& view);
  std::string judgeHeartbeat(const CycleView& view);
  [[nodiscard]] bool isTooSoon(const CycleView& view, double silent_s) const;

  const JudgeSetup& s_;
  int wrong_clocks_;   ///< of the clocks that hookbeh uses
  double last_s_ = 0;  ///< of the previous cycle

  double reading_m_ = 0;  ///< of m_depth in the previous cycle
  double right_s_ = 0;    ///< how long it has been near the truth
  double stood_m_ = 0;    ///< of m_depth when it last changed in this climb
  double climbs_s_ = 0;   ///< how long it has not changed in this climb
  double away_s_ = 0;     ///< how long another behaviour has controlled the pump
  bool stalled_ = false;  ///< by a guard, in the previous cycle
  uint8_t masked_ = 0;    ///< what others replaced of its commands in the previous cycle

  hooks::HookState hook_ = hooks::HookState::Absent;  ///< in the previous cycle
  double heartbeat_ = 0;                              ///< the newest one
  double heard_s_ = 0;                                ///< when it arrived, or a session began
  double last_number_ = 0;                            ///< the newest heartbeat, with its sign
  double own_s_ = 0;                                  ///< the same of one that is not negative
  double session_ = 0;                                ///< in control, in the previous cycle
};

}  // namespace glider::slocum::oracles
