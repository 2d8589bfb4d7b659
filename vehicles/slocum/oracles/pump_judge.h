// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/protocol/instruction.h"
#include "vehicles/slocum/oracles/judge_setup.h"
#include "vehicles/slocum/oracles/names.h"

#include <string>

namespace glider::slocum::oracles {

/// Checks how much the buoyancy pump moves and what it takes from the batteries, against stated
/// limits: a mission that flips its commands every few cycles wears it and drains them. What a
/// mission commands that a wrong sensor misleads does not count.
class PumpJudge {
 public:
  explicit PumpJudge(const JudgeSetup& setup) : s_(setup) {}

  /// What is violated in this cycle while `in_force` is; empty: nothing.
  std::string cycle(const CycleView& view, const hooks::Instruction& in_force);

 private:
  bool isMisled(const CycleView& view, const hooks::Instruction& in_force);

  const JudgeSetup& s_;
  hooks::Instruction in_force_;           ///< in the previous cycle
  double instructed_s_ = -1e9;            ///< when its vertical part last changed
  double last_s_ = 0;                     ///< of the previous cycle
  double pumped_cc_ = __builtin_nan("");  ///< then
  double used_J_ = 0;                     ///< then
  double strokes_ = 0;                    ///< that are more than the lasting rate
  double more_J_ = 0;                     ///< the same of the energy
};

}  // namespace glider::slocum::oracles
