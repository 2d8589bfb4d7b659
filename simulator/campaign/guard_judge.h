// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/campaign/judge_setup.h"
#include "simulator/flight_observer.h"

#include <string>

namespace glider::simulator {

/// Judges hookbeh's guards by what lies in the sensor array and by the truth, where no limit of
/// depth is broken yet: a guard that is missing may be covered by another, and the vehicle lives on
/// one guard less than it should.
class GuardJudge {
 public:
  explicit GuardJudge(const JudgeSetup& setup);

  /// What is violated in this cycle; empty: nothing.
  std::string cycle(const CycleView& view);
  /// Another hookbeh begins.
  void restart();

 private:
  std::string judgePump(const CycleView& view) const;
  std::string judgeJump(const CycleView& view);
  std::string judgeClimb(const CycleView& view);
  std::string judgeOverridden(const CycleView& view);
  std::string judgeHeartbeat(const CycleView& view);
  [[nodiscard]] bool isTooSoon(const CycleView& view, double silent_s) const;

  const JudgeSetup& s_;
  int wrong_clocks_;   ///< of those that hookbeh tells the time by
  double last_s_ = 0;  ///< of the cycle before

  double reading_m_ = 0;  ///< of m_depth in the cycle before
  double right_s_ = 0;    ///< so long it has been near the truth
  double stood_m_ = 0;    ///< that m_depth said when it last moved in this climb
  double climbs_s_ = 0;   ///< so long it has stood still in this climb
  double away_s_ = 0;     ///< so long another behaviour has had the pump
  bool stalled_ = false;  ///< by a guard, in the cycle before

  hooks::HookState hook_ = hooks::HookState::Absent;  ///< in the cycle before
  double heartbeat_ = 0;                              ///< the newest
  double heard_s_ = 0;                                ///< when it came, or a session began
  double session_ = 0;                                ///< in control, in the cycle before
};

}  // namespace glider::simulator
