// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "vehicles/slocum/oracles/judge_setup.h"
#include "vehicles/slocum/oracles/names.h"

#include <string>

namespace glider::slocum::oracles {

/// Checks where the vehicle is: not on land or at the shore while something steers it, no faster
/// than the environment model says, and no faster than the current once it floats without control.
class PositionJudge {
 public:
  explicit PositionJudge(const JudgeSetup& setup) : s_(setup) {}

  /// What is violated in this cycle; empty: nothing.
  std::string cycle(const CycleView& view);

 private:
  std::string judgeShore(const CycleView& view, bool steered);
  std::string judgeSpeed(const CycleView& view, bool floats);

  const JudgeSetup& s_;
  bool was_off_shore_ = false;  ///< a flight may begin at the shore
  double from_s_ = 0;           ///< since when the speed is measured, and from where
  double from_east_m_ = 0, from_north_m_ = 0;
  bool floated_ = false;  ///< all this time, without control
};

}  // namespace glider::slocum::oracles
