// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "vehicles/slocum/oracles/judge_setup.h"
#include "vehicles/slocum/oracles/names.h"

#include <string>

namespace glider::slocum::oracles {

/// Checks that the vehicle surfaces in time when nothing is left that dives.
class AscentJudge {
 public:
  explicit AscentJudge(const JudgeSetup& setup) : s_(setup) {}

  /// What is violated in this cycle; empty: nothing.
  std::string cycle(const CycleView& view);
  /// True if it was under water in the last cycle, on its way up, and still has time to surface.
  [[nodiscard]] bool isComingUp() const { return up_by_s_ >= last_s_; }

 private:
  const JudgeSetup& s_;
  double last_s_ = 0;    ///< of the previous cycle
  double up_by_s_ = -1;  ///< the latest time to be at the surface; negative: something still dives
};

}  // namespace glider::slocum::oracles
