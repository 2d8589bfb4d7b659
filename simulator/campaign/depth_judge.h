// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/campaign/judge_setup.h"
#include "simulator/flight_observer.h"

#include <string>

namespace glider::simulator {

/// Judges the true depth against the limit in force (hookbeh's max_depth while the SBC has control,
/// else abend's overdepth) and against the hull's, and the true clearance over the bottom.
class DepthJudge {
 public:
  explicit DepthJudge(const JudgeSetup& setup) : s_(setup) {}

  /// What is violated in this cycle; empty: nothing.
  std::string cycle(const CycleView& view);
  /// The deepest that it was, and the least clearance while the SBC had control, m.
  [[nodiscard]] double deepest() const { return deepest_m_; }

 private:
  [[nodiscard]] double limitNow(bool active) const;
  std::string judgeDepth(const CycleView& view, bool active);
  std::string judgeClearance(const CycleView& view, bool active);
  bool isNewOnBottom(const CycleView& view);

  const JudgeSetup& s_;
  double deepest_m_ = 0;
  double limit_m_ = -1;   ///< in force in the cycle before
  double excess_m_ = 0;   ///< so far the vehicle was past the limit when that came into force
  double lacking_m_ = 0;  ///< so far it was below the least altitude when the SBC took control
  bool was_active_ = false;
  double cycle_at_s_ = __builtin_nan("");  ///< when the cycle before was
  bool met_bottom_in_dark_ = false;        ///< and has not left it since
};

}  // namespace glider::simulator
