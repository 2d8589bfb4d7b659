// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "vehicles/slocum/oracles/judge_setup.h"
#include "vehicles/slocum/oracles/names.h"

#include <string>

namespace glider::slocum::oracles {

/// Checks the batteries: against what the mission usually takes, the voltage at which abend ends
/// the mission, what they hold, and what the way up takes.
class BatteryJudge {
 public:
  explicit BatteryJudge(const JudgeSetup& setup) : s_(setup) {}

  /// What is violated in this cycle; empty: nothing.
  std::string cycle(const CycleView& view);
  /// What the way up from `depth_m` takes, J: a full stroke of the pump there, and the loads for
  /// the time that the environment model allows.
  [[nodiscard]] double wayUpJ(double depth_m) const;

 private:
  std::string judgeUse(const CycleView& view) const;
  std::string judgeVoltage(const CycleView& view);
  std::string judgeWayUp(const CycleView& view) const;

  const JudgeSetup& s_;
  double below_since_s_ = -1;  ///< since when the voltage is below the abort limit
};

}  // namespace glider::slocum::oracles
