// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/campaign/judge_setup.h"
#include "simulator/flight_observer.h"

#include <string>

namespace glider::simulator {

/// Checks what the vehicle does by itself: it surfaces in time when nothing is left that dives, and
/// its batteries last as long as they must.
class EndingJudge {
 public:
  explicit EndingJudge(const JudgeSetup& setup);

  /// What is violated in this cycle; empty: nothing.
  std::string cycle(const CycleView& view);
  /// True if it was under water in the last cycle, on its way up, and still has time to surface.
  [[nodiscard]] bool isComingUp() const { return up_by_s_ >= last_s_; }

 private:
  std::string judgeAscent(const CycleView& view);
  std::string judgeBattery(const CycleView& view);

  const JudgeSetup& s_;
  bool voltage_known_;   ///< no fault damages its sensor
  double last_s_ = 0;    ///< of the previous cycle
  double up_by_s_ = -1;  ///< the latest time to be at the surface; negative: something still dives
  double below_since_s_ = -1;  ///< since when the voltage is below the abort limit
};

}  // namespace glider::simulator
