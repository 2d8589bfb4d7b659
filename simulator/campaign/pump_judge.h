// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/campaign/judge_setup.h"
#include "simulator/flight_observer.h"

#include <string>

namespace glider::simulator {

/// Checks how much the buoyancy pump moves and what it takes from the batteries, against stated
/// limits: a mission that flips its commands every few cycles wears it and drains them.
class PumpJudge {
 public:
  explicit PumpJudge(const JudgeSetup& setup) : s_(setup) {}

  /// What is violated in this cycle; empty: nothing.
  std::string cycle(const CycleView& view);

 private:
  const JudgeSetup& s_;
  double last_s_ = 0;                     ///< of the previous cycle
  double pumped_cc_ = __builtin_nan("");  ///< then
  double used_J_ = 0;                     ///< then
  double strokes_ = 0;                    ///< that are more than the lasting rate
  double more_J_ = 0;                     ///< the same of the energy
};

}  // namespace glider::simulator
