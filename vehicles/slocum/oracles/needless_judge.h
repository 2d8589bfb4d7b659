// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "vehicles/slocum/oracles/depth_trust.h"
#include "vehicles/slocum/oracles/judge_setup.h"
#include "vehicles/slocum/oracles/names.h"
#include "vehicles/slocum/oracles/newest_echo.h"

#include <string>

namespace glider::slocum::oracles {

/// Counts climbs of guards that nothing made necessary: no limit is near, and all that hookbeh
/// reads of depth and bottom has been right for some time. A harmless fault of another sensor may
/// cause a few; more of them wear the pump and take the energy of the mission.
class NeedlessJudge {
 public:
  explicit NeedlessJudge(const JudgeSetup& setup) : s_(setup) {}

  /// What is violated in this cycle; empty: nothing.
  std::string cycle(const CycleView& view);
  /// A new hookbeh begins.
  void restart() {
    guarding_ = needless_ = false;
    trust_ = {};
  }

 private:
  [[nodiscard]] bool isSafe(const CycleView& view) const;

  const JudgeSetup& s_;
  DepthTrust trust_;
  double last_s_ = 0;   ///< of the previous cycle
  double right_s_ = 0;  ///< how long readings and distances have been right
  NewestEcho echo_;
  bool guarding_ = false;  ///< in the previous cycle
  bool needless_ = false;  ///< this climb
  int climbs_ = 0;         ///< needless ones
  double climb_s_ = 0;     ///< their time
  double active_s_ = 0;    ///< the SBC was in control
};

}  // namespace glider::slocum::oracles
