// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/protocol/values.h"
#include "simulator/campaign/judge_setup.h"
#include "simulator/flight_observer.h"

#include <limits>
#include <string>

namespace glider::simulator {

/// Judges what hookbeh commands in each cycle, by what hooks/hookbeh/README.md says: everything or
/// nothing, within its b_args; up where a limit is broken; else what the instruction in force
/// wants.
class CommandJudge {
 public:
  explicit CommandJudge(const JudgeSetup& setup) : s_(setup) {}

  /// hookbeh has answered an instruction; to be called before the cycle in which it did.
  std::string answered(const hooks::Instruction& instruction, hooks::HookAnswer answer);
  /// What is violated in this cycle; empty: nothing.
  std::string cycle(const CycleView& view);
  /// The mission begins again.
  void restart();

 private:
  [[nodiscard]] hooks::HookAnswer boundsOf(const hooks::Instruction& instruction) const;
  std::string judgeWhole(const CycleView& view) const;
  std::string judgeLimits(const CycleView& view, double reading);
  std::string judgeBlind(const CycleView& view, double reading);
  std::string judgeGuard(const CycleView& view);
  std::string judgeFollowing(const CycleView& view, double reading);
  std::string judgeDive(const hooks::HookbehOutputs& out, double reading);
  std::string judgeClimb(const hooks::HookbehOutputs& out, double reading);
  std::string judgeHover(const hooks::HookbehOutputs& out, double reading);
  std::string judgeStaying(const hooks::HookbehOutputs& out, double reading);

  const JudgeSetup& s_;
  hooks::Instruction in_force_;
  bool arrived_ = false;
  bool goes_back_ = false;    ///< to a depth that it had reached before the guard came
  bool carried_off_ = false;  ///< from such a depth, by a behaviour above hookbeh
  int arrived_cycles_ = 0, far_cycles_ = 0;
  int too_deep_cycles_ = 0, too_low_cycles_ = 0;

  double reading_m_ = 0;        ///< of m_depth in the cycle before
  double same_s_ = 0;           ///< it has been the same to the last bit for so long, in a dive
  double wrong_s_ = 0;          ///< it has been far from the truth for so long, in a dive
  double idle_s_ = 0;           ///< so long a dive has gained no metre
  bool excused_ = false;        ///< in this session guard 6 has climbed for what old frames say
  double deepest_m_ = -1e9;     ///< that m_depth said in this dive
  double overridden_s_ = -1e9;  ///< when a behaviour above hookbeh had pitch or pump last

  bool guarding_ = false;
  bool no_depth_gained_ = false;  ///< by its guard, which outlives sessions
  double tripped_m_ = 0;          ///< true depth at which the guard came in
  double shallowest_m_ = std::numeric_limits<double>::infinity();  ///< since then
  int late_cycles_ = 0;                                            ///< since it should have let go
  int small_swings_ = 0;                                           ///< in a row
};

}  // namespace glider::simulator
