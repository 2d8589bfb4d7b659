// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/protocol/instruction.h"
#include "vehicles/slocum/oracles/depth_trust.h"
#include "vehicles/slocum/oracles/judge_setup.h"
#include "vehicles/slocum/oracles/names.h"

#include <string>

namespace glider::slocum::oracles {

/// True if what the vehicle knows of its depth and of the bottom is right in this cycle: hookbeh
/// then has no reason to keep it up.
bool readingsAreRight(const CycleView& view);

/// Checks that a vehicle does not stay at the surface without a reason: a depth is commanded, the
/// water is deep enough, nothing else has had the motors for a while, and the readings are right
/// and believed.
class SurfaceJudge {
 public:
  explicit SurfaceJudge(const JudgeSetup& setup) : s_(setup) {}

  /// What is violated in this cycle while `in_force` is; empty: nothing.
  std::string cycle(const CycleView& view, const hooks::Instruction& in_force);
  /// A new hookbeh begins, which believes the depth.
  void restart() { trust_ = {}; }

 private:
  [[nodiscard]] bool shouldDive(const CycleView& view, const hooks::Instruction& in_force) const;

  const JudgeSetup& s_;
  DepthTrust trust_;
  double last_s_ = 0;     ///< of the previous cycle
  double ours_s_ = 0;     ///< how long the SBC has had the motors
  double right_s_ = 0;    ///< how long the readings have been right
  double stays_s_ = 0;    ///< at the surface, without a break
  double wanted_s_ = 0;   ///< in all, how long it should have been under water
  double surface_s_ = 0;  ///< of this, at the surface
};

}  // namespace glider::slocum::oracles
