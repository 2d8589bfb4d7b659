// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#ifndef GLIDER_HOOKS_HOOKBEH_HOOKBEH_H
#define GLIDER_HOOKS_HOOKBEH_HOOKBEH_H

#include "hooks/hookbeh/args.h"
#include "hooks/hookbeh/command.h"
#include "hooks/hookbeh/cycle_clock.h"
#include "hooks/hookbeh/guard.h"
#include "hooks/hookbeh/hull.h"
#include "hooks/hookbeh/pilot.h"
#include "hooks/protocol/instruction.h"
#include "hooks/protocol/numbers.h"

/// The behaviour `hookbeh` of the layered control: takes the SBC's instructions from the sensor
/// array, bounds them by its own b_args, and runs sub-behaviours. It never trusts the SBC.
/// Portable: no heap, no libc.
GLIDER_HOOKS_BEGIN

/// What hookbeh reads from the sensor array in one cycle; NaN for a value never set.
typedef struct HookbehInputs {
  HookInstructionWords words;
  double time_s GLIDER_IS(0);  ///< m_present_secs_into_mission
  double depth_m GLIDER_IS(0);
  double depth_rate_mps GLIDER_IS(0);
  double altitude_m GLIDER_IS(0);
  double latitude_ddmm GLIDER_IS(0);
  double longitude_ddmm GLIDER_IS(0);
  double heartbeat GLIDER_IS(0);  ///< negative: hookprog gives it for an SBC that sleeps
  // What the others are compared with; a vehicle may lack any of them.
  double wall_time_s GLIDER_IS(hookUnknown());   ///< m_present_time
  double cycle_number GLIDER_IS(hookUnknown());  ///< m_cycle_number
  double ctd_bar GLIDER_IS(hookUnknown());  ///< sci_water_pressure, NaN in a cycle without a new
                                            ///< one
  /// c_ballast_pumped: what all behaviours together commanded in the previous cycle.
  double commanded_pump_cc GLIDER_IS(hookUnknown());
  /// kHookMaskedHeading… of the previous cycle, as the layered control knows. 0 if it does not:
  /// then only a pump that moves elsewhere is noticed.
  uint8_t masked GLIDER_IS(0);
} HookbehInputs;

/// What it commands and reports in one cycle. When `commanding`, heading, pitch and pump are all
/// commanded.
typedef struct HookbehOutputs {
  bool commanding GLIDER_IS(false);
  HookHeadingMode heading_mode GLIDER_IS(HookHeadingMode::CentreFin);
  double heading_rad GLIDER_IS(0);
  double latitude_ddmm GLIDER_IS(0);
  double longitude_ddmm GLIDER_IS(0);
  double fin_rad GLIDER_IS(0);  ///< positive to turn to starboard
  HookPitchMode pitch_mode GLIDER_IS(HookPitchMode::Servo);
  double pitch_rad GLIDER_IS(0);   ///< of the servo; 0 with a battery position
  double battery_in GLIDER_IS(0);  ///< of the pitch battery, positive lowers the nose
  double pump_cc GLIDER_IS(0);
  // Written back to the sensor array:
  HookState state GLIDER_IS(HookState::Waiting);
  uint16_t answered_sequence GLIDER_IS(0);
  HookAnswer answer GLIDER_IS(HookAnswer::None);
  uint32_t session GLIDER_IS(0);
  double nap_secs GLIDER_IS(0);                   ///< its b_arg, x_hook_nap_secs
  HookDoing doing GLIDER_IS(HookDoing::Nothing);  ///< for logs
  HookGuard guard GLIDER_IS(HookGuard::None);     ///< why it climbs against any instruction of the
                                                  ///< SBC
  uint8_t masked GLIDER_IS(0);                    ///< kHookMaskedHeading… of the previous cycle
  /// The altimeter must be read in each cycle, as for a dive to an altitude, also if the mission
  /// file has switched it off.
  bool altimeter GLIDER_IS(false);
  /// How often the instruments read (protocol/sampling.h), before what the mission file says; 0: as
  /// that says, also while it commands nothing.
  uint32_t sampling GLIDER_IS(0);
} HookbehOutputs;

/// One hookbeh: set by hookbehInit(), and read and written by nothing but hookbehCycle().
typedef struct Hookbeh {
  HookHull hull;
  HookbehArgs args;
  HookState state;
  HookbehGuard guard;
  HookPilot pilot;
  HookCycleClock clock;
  bool guarding;  ///< in the previous cycle
  bool checked;   ///< it climbed then only to check the depth
  bool masked;    ///< pitch or pump were not its own
  /// Of the newest heartbeat: 0 of the SBC itself; in its place 1, with an odd number 2.
  uint8_t beat_kind;
  HookVerticalCommand last;  ///< it commanded then; pump NaN: nothing

  uint32_t heartbeat;  ///< the newest seen, 0 for none
  double silence_s;    ///< since it last advanced
  double nap_s;        ///< since it last came from the SBC itself
  double garbled_s;    ///< how long an instruction in the sensor array has been unreadable

  bool settled_known;
  uint16_t settled_sequence;  ///< its instruction was decided on, once only
  HookAnswer settled_answer;
  uint16_t answered_sequence;
  HookAnswer answer;
  uint32_t session;       ///< in control
  uint32_t lost_session;  ///< newest that was lost
} Hookbeh;

/// `args` are narrowed to the limits of the hull.
void hookbehInit(Hookbeh* hookbeh, const HookbehArgs* args, const HookHull* hull);
/// All zero, and NaN for what a vehicle may lack.
void hookbehNoInputs(HookbehInputs* inputs);
/// One control cycle.
void hookbehCycle(Hookbeh* hookbeh, const HookbehInputs* inputs, HookbehOutputs* outputs);

GLIDER_HOOKS_END

#ifdef __cplusplus
namespace glider::hooks {
using ::HookbehInputs;
using ::HookbehOutputs;

class Hookbeh {
 public:
  Hookbeh(const HookbehArgs& args, const Hull& hull) { hookbehInit(&hookbeh_, &args, &hull); }
  HookbehOutputs cycle(const HookbehInputs& inputs) {
    HookbehOutputs outputs;
    hookbehCycle(&hookbeh_, &inputs, &outputs);
    return outputs;
  }

 private:
  ::Hookbeh hookbeh_;
};
}  // namespace glider::hooks
#endif

#endif
