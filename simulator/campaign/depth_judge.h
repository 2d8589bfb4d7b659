// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/campaign/judge_setup.h"
#include "simulator/flight_observer.h"

#include <string>

namespace glider::simulator {

/// Checks the true depth against the limit in force (hookbeh's max_depth while the SBC has control,
/// else abend's overdepth) and against the hull's limit, and checks the true clearance over the
/// bottom.
class DepthJudge {
 public:
  explicit DepthJudge(const JudgeSetup& setup) : s_(setup) {}

  /// What is violated in this cycle; empty: nothing.
  std::string cycle(const CycleView& view);
  /// The greatest depth, and the least clearance while the SBC had control, m.
  [[nodiscard]] double deepest() const { return deepest_m_; }

 private:
  [[nodiscard]] double limitNow(bool active) const;
  std::string judgeDepth(const CycleView& view, bool active);
  std::string judgeClearance(const CycleView& view, bool active);
  bool isNewOnBottom(const CycleView& view);

  const JudgeSetup& s_;
  double deepest_m_ = 0;
  double limit_m_ = -1;   ///< in force in the previous cycle
  double excess_m_ = 0;   ///< how far the vehicle was past the limit when it came into force
  double lacking_m_ = 0;  ///< how far it was below the least altitude when the SBC took control
  bool was_active_ = false;
  double cycle_at_s_ = __builtin_nan("");  ///< when the previous cycle was
  bool met_bottom_in_dark_ = false;        ///< and has not left it since
};

}  // namespace glider::simulator
