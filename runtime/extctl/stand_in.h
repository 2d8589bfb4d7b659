// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/hookbeh/args.h"
#include "hooks/protocol/instruction.h"
#include "hooks/seat/seat.h"
#include "runtime/abi/port_mission.h"

#include <stdint.h>

namespace glider::runtime::extctl {

/// What the vehicle says of the mission that it flies; NaN: not reported yet.
struct VehicleMission {
  double time_s = __builtin_nan("");   ///< m_present_secs_into_mission
  double clock_s = __builtin_nan("");  ///< m_present_time
  double program = __builtin_nan("");  ///< u_mission_param_l
  double in_glider_dos = __builtin_nan("");
  bool at_surface = true;  ///< so near that a mission may begin
};

/// Answers the mission's instructions where the vehicle has no hookbeh to do it: refuses those that
/// are out of bounds and keeps the one that is in force. A vehicle reports changes only, so a
/// program that was started in mid-flight may never learn which mission file flies.
class StandIn {
 public:
  /// `last`: when the vehicle last reported according to the checkpoint; null: there is none.
  StandIn(const GliderPortMission& port, const VehicleMission* last);

  /// A control cycle of the vehicle. `answered`: everything that was to be written before has left.
  void observe(const VehicleMission& vehicle, bool answered = true);
  /// The vehicle has begun another mission since the last call: what it was sent before is void.
  bool takeRestart();
  /// Whether no program can have steered the vehicle's present mission before this one.
  [[nodiscard]] bool knowsStart() const { return first_s_ < kBeginSecs; }
  /// Whether the vehicle is to come up before control is given. A program that begins in the midst
  /// of the vehicle's mission, without a checkpoint of it, does not know which targets an earlier
  /// one has left, and the vehicle would dive to them until the first command is obeyed.
  [[nodiscard]] bool makesSafe() const { return makes_safe_; }
  /// An answer has left with which the vehicle is to come up.
  void toldToComeUp() { told_ = makes_safe_; }
  /// For how long it has been brought up, s of its mission; NaN: it is not.
  [[nodiscard]] const double* comesUpFor() const { return &comes_up_for_s_; }
  /// What was written may be lost.
  void forget();
  /// An instruction of the program's own mission.
  void instruct(const hooks::Instruction& instruction);

  [[nodiscard]] hooks::HookState state() const { return state_; }
  [[nodiscard]] hooks::HookAnswer answer() const { return answer_; }
  /// The number of the instruction that has the answer, 0 before the first.
  [[nodiscard]] uint16_t answered() const { return answered_; }
  /// In control, 0 for none.
  [[nodiscard]] uint32_t session() const { return session_; }
  /// The command in force; null before the first. It stays in force when the session ends: so does
  /// what the vehicle has received.
  [[nodiscard]] const hooks::Instruction* inForce() const {
    return has_command_ ? &command_ : nullptr;
  }
  /// The mission has ended: the vehicle is to come up. The release is answered only when it has
  /// been up for kStaysUpSecs, and after kReleaseCycles: the program ends then, and what was lost
  /// is not repeated.
  [[nodiscard]] bool released() const {
    return releasing_ != 0 || state_ == hooks::HookState::Complete;
  }
  static constexpr uint32_t kReleaseCycles = 8;
  /// Longer than a yo stays near the surface when it turns there, s.
  static constexpr double kStaysUpSecs = 60;
  /// The program's mission is over: whether nothing is left to be written. A vehicle that flies the
  /// mission file obeys what an earlier program has written, and is first brought up, as by a
  /// release.
  bool mayEnd();
  /// Not before this time of the vehicle's mission: what was written into an earlier one may still
  /// be on its way, and so may the number of the mission file, s.
  static constexpr double kBeginSecs = 20;
  /// After the first answer with them that has left, the wish to surface and the shallowest yo have
  /// arrived: its dive is written when every climb that may have been in force is over (kSettleSecs
  /// of hooks/extctl/port.h, twice), s.
  static constexpr double kSafeSecs = 44;
  /// How much the two clocks of the vehicle may differ over an outage of the program, s.
  static constexpr double kSameFlightSecs = 60;

 private:
  [[nodiscard]] hooks::HookState stateOf(const VehicleMission& vehicle) const;
  [[nodiscard]] bool isSameFlight(const VehicleMission& vehicle) const;
  [[nodiscard]] bool goesOn(const VehicleMission& vehicle) const;
  void lookWhetherSafe(const VehicleMission& vehicle);
  void setMakesSafe(bool makes);
  [[nodiscard]] bool isOver(const VehicleMission& vehicle) const;
  [[nodiscard]] bool isRelease(const hooks::Instruction& instruction) const;
  [[nodiscard]] hooks::HookAnswer decide(const hooks::Instruction& instruction);
  void loseSession();
  void finishRelease(bool answered);

  GliderPortMission port_;
  hooks::HookbehArgs bounds_;
  VehicleMission last_;
  bool restarted_ = true;
  hooks::HookState state_ = hooks::HookState::Absent;
  double time_s_ = 0;
  double first_s_ = __builtin_nan("");  ///< of the vehicle's mission, when it was first seen
  bool makes_safe_ = false;
  bool safe_ = false;
  double up_since_s_ = __builtin_nan("");      ///< since when it is at the surface; NaN: it is not
  double comes_up_s_ = __builtin_nan("");      ///< since when it is brought up; NaN: it is not
  double comes_up_for_s_ = __builtin_nan("");  ///< until now
  bool told_ = false;                          ///< an answer with that has left
  double told_s_ = __builtin_nan("");          ///< since when, as the vehicle's reports show
  hooks::Instruction command_;
  bool has_command_ = false;
  uint32_t session_ = 0;
  uint32_t lost_session_ = 0;
  uint16_t answered_ = 0;
  uint32_t releasing_ = 0;  ///< cycles since the release was asked for, 0: it was not
  uint16_t release_ = 0;    ///< its number
  hooks::HookAnswer answer_ = hooks::HookAnswer::None;
};

}  // namespace glider::runtime::extctl
