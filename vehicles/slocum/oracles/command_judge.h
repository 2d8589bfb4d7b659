// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/protocol/instruction.h"
#include "vehicles/slocum/oracles/judge_setup.h"
#include "vehicles/slocum/oracles/names.h"
#include "vehicles/slocum/oracles/newest_echo.h"

#include <limits>
#include <string>

namespace glider::slocum::oracles {

/// Checks what hookbeh commands in each cycle against hooks/hookbeh/README.md: all channels or
/// none, within its b_args; a climb if a limit is broken; otherwise what the instruction in force
/// requires.
class CommandJudge {
 public:
  explicit CommandJudge(const JudgeSetup& setup) : s_(setup) {}

  /// hookbeh has answered an instruction; must be called before the cycle in which it did.
  std::string answered(const hooks::Instruction& instruction, hooks::HookAnswer answer);
  /// What is violated in this cycle; empty: nothing.
  std::string cycle(const CycleView& view);
  /// The mission restarts.
  void restart();
  /// The instruction that hookbeh carries out; without control an empty one.
  [[nodiscard]] const hooks::Instruction& inForce() const { return in_force_; }

 private:
  [[nodiscard]] hooks::HookAnswer boundsOf(const hooks::Instruction& instruction) const;
  std::string judgeWhole(const CycleView& view) const;
  [[nodiscard]] bool isExcused(const CycleView& view);
  std::string judgeLimits(const CycleView& view, double reading);
  std::string judgeBlind(const CycleView& view, double reading);
  std::string judgeGuard(const CycleView& view);
  /// Checks that the fin is held at the commanded angle, and only then.
  [[nodiscard]] std::string judgeFin(const hooks::HookbehOutputs& out) const;
  /// Checks that pump and battery are where they are commanded.
  [[nodiscard]] std::string judgeActuators(const hooks::HookbehOutputs& out) const;
  std::string judgeFollowing(const CycleView& view, double reading);
  std::string judgeDive(const hooks::HookbehOutputs& out, double reading);
  std::string judgeClimb(const hooks::HookbehOutputs& out, double reading);
  std::string judgeHover(const hooks::HookbehOutputs& out, double reading);
  std::string judgeStaying(const CycleView& view, double reading);

  const JudgeSetup& s_;
  hooks::Instruction in_force_;
  bool arrived_ = false;
  bool goes_back_ = false;    ///< to a depth that it had reached before the guard stepped in
  bool carried_off_ = false;  ///< from such a depth, by a behaviour above hookbeh
  int arrived_cycles_ = 0, far_cycles_ = 0;
  int too_deep_cycles_ = 0, too_low_cycles_ = 0;

  double reading_m_ = 0;        ///< of m_depth in the previous cycle
  double same_s_ = 0;           ///< how long it has been identical to the last bit, in a dive
  double wrong_s_ = 0;          ///< how long it has been far from the truth, in a dive
  double idle_s_ = 0;           ///< how long a dive has not gained a metre
  double excused_s_ = -1e9;     ///< when guard 6 last climbed because of old frames
  double deepest_m_ = -1e9;     ///< of m_depth in this dive, when it last gained a metre
  double crept_m_ = -1e9;       ///< and the greatest since then
  double overridden_s_ = -1e9;  ///< when a behaviour above hookbeh last controlled pitch or pump

  NewestEcho echo_;
  bool guarding_ = false;
  bool no_depth_gained_ = false;  ///< by its guard, which persists across sessions
  double tripped_m_ = 0;          ///< true depth at which the guard stepped in, and when
  double tripped_s_ = 0;
  double near_m_ = 0;      ///< where since then a limit was last near
  double brief_s_ = -1e9;  ///< when a brief climb of the guard last ended
  double shallowest_m_ = std::numeric_limits<double>::infinity();  ///< since then
  int late_cycles_ = 0;   ///< since it should have stopped climbing
  int small_swings_ = 0;  ///< of the guard, in a row
};

}  // namespace glider::slocum::oracles
