// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/hookbeh/args.h"
#include "hooks/hookbeh/command.h"
#include "hooks/hookbeh/cycle_clock.h"
#include "hooks/hookbeh/guard.h"
#include "hooks/hookbeh/hull.h"
#include "hooks/hookbeh/pilot.h"
#include "hooks/protocol/instruction.h"

#include <stdint.h>

/// The behaviour `hookbeh` of the layered control: takes the SBC's instructions from the sensor
/// array, bounds them by its own b_args, and runs sub-behaviours. It never trusts the SBC.
/// Portable: no heap, no libc.
namespace glider::hooks {

/// What hookbeh reads from the sensor array in one cycle; NaN for a value never set.
struct HookbehInputs : InstructionWords {
  double time_s = 0;  ///< m_present_secs_into_mission
  double depth_m = 0;
  double depth_rate_mps = 0;
  double altitude_m = 0;
  double latitude_ddmm = 0;
  double longitude_ddmm = 0;
  double heartbeat = 0;
  // What the others are compared with; a vehicle may lack any of them.
  double wall_time_s = __builtin_nan("");   ///< m_present_time
  double cycle_number = __builtin_nan("");  ///< m_cycle_number
  double ctd_bar = __builtin_nan("");  ///< sci_water_pressure, NaN in a cycle without a new one
  /// c_ballast_pumped: what all behaviours together commanded in the previous cycle.
  double commanded_pump_cc = __builtin_nan("");
  /// kMaskedHeading… of the previous cycle, as the layered control knows. 0 if it does not: then
  /// only a pump that moves elsewhere is noticed.
  uint8_t masked = 0;
};

/// What it commands and reports in one cycle. When `commanding`, heading, pitch and pump are all
/// commanded.
struct HookbehOutputs {
  bool commanding = false;
  HeadingMode heading_mode = HeadingMode::CentreFin;
  double heading_rad = 0;
  double latitude_ddmm = 0, longitude_ddmm = 0;
  double fin_rad = 0;  ///< positive to turn to starboard
  PitchMode pitch_mode = PitchMode::Servo;
  double pitch_rad = 0;   ///< of the servo; 0 with a battery position
  double battery_in = 0;  ///< of the pitch battery, positive lowers the nose
  double pump_cc = 0;
  // Written back to the sensor array:
  HookState state = HookState::Waiting;
  uint16_t answered_sequence = 0;
  HookAnswer answer = HookAnswer::None;
  uint32_t session = 0;
  Doing doing = Doing::Nothing;       ///< for logs
  HookGuard guard = HookGuard::None;  ///< why it climbs against any instruction of the SBC
  uint8_t masked = 0;                 ///< kMaskedHeading… of the previous cycle
  /// The altimeter must be read in each cycle, as for a dive to an altitude, also if the mission
  /// file has switched it off.
  bool altimeter = false;
};

class Hookbeh {
 public:
  /// `args` are narrowed to the limits of the hull.
  Hookbeh(const HookbehArgs& args, const Hull& hull);
  /// One control cycle.
  HookbehOutputs cycle(const HookbehInputs& inputs);

 private:
  void watchHeartbeat(double heartbeat);
  void readInstruction(const HookbehInputs& inputs);
  void loseSession();
  HookAnswer decide(const Instruction& instruction);
  HookAnswer take(const Instruction& instruction);
  HookAnswer release();
  void command(const Surroundings& now, bool masked, HookbehOutputs& outputs);
  [[nodiscard]] uint8_t maskedIn(const HookbehInputs& inputs) const;
  [[nodiscard]] VerticalCommand vertical(const Surroundings& now, HookGuard guard, bool masked);

  Hull hull_;
  HookbehArgs args_;
  HookState state_ = HookState::Waiting;
  Guard guard_;
  Pilot pilot_;
  CycleClock clock_;
  bool guarding_ = false;                       // in the previous cycle
  bool checked_ = false;                        // it climbed then to check the depth
  bool masked_ = false;                         // pitch or pump were not its own
  VerticalCommand last_{0, __builtin_nan("")};  // it commanded then; pump NaN: nothing

  uint32_t heartbeat_ = 0;  // the newest seen, 0 for none
  double silence_s_ = 0;    // since it last advanced
  double garbled_s_ = 0;    // how long an instruction in the sensor array has been unreadable

  bool settled_known_ = false;
  uint16_t settled_sequence_ = 0;  // its instruction was decided on, once only
  HookAnswer settled_answer_ = HookAnswer::None;
  uint16_t answered_sequence_ = 0;
  HookAnswer answer_ = HookAnswer::None;
  uint32_t session_ = 0;       // in control
  uint32_t lost_session_ = 0;  // newest that was lost
};

}  // namespace glider::hooks
