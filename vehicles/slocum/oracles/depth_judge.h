// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "vehicles/slocum/oracles/judge_setup.h"
#include "vehicles/slocum/oracles/names.h"

#include <string>

namespace glider::slocum::oracles {

/// Checks the true depth against the limit in force (hookbeh's max_depth while the SBC has control,
/// else abend's overdepth) and against the hull's limit. A vehicle that is deeper when a limit
/// comes into force, or after the flight controller was down, may only come up from there: nothing
/// but the time without a flight controller adds to what is allowed.
class DepthJudge {
 public:
  explicit DepthJudge(const JudgeSetup& setup) : s_(setup) {}

  /// What is violated in this cycle; empty: nothing.
  std::string cycle(const CycleView& view);
  /// The greatest depth, m.
  [[nodiscard]] double deepest() const { return deepest_m_; }

 private:
  [[nodiscard]] double limitNow(bool active) const;
  [[nodiscard]] double sinkRate(const CycleView& view) const;
  void followDark(const CycleView& view);
  std::string judgeDepth(const CycleView& view, bool active);

  const JudgeSetup& s_;
  double deepest_m_ = 0;
  double usual_m_ = 0;                 ///< by the limit in force alone
  double allowed_m_ = 0;               ///< the greatest depth, now
  double last_s_ = __builtin_nan("");  ///< the previous cycle
  double last_m_ = 0;                  ///< true depth then
  double sinks_mps_ = 0;               ///< at most, by the commands of then
};

/// How fast a vehicle sinks at most with these commands, m/s; NaN counts as the steepest dive.
double sinkRate(double pitch_rad, double pump_cc);

}  // namespace glider::slocum::oracles
