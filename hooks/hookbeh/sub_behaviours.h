// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#ifndef GLIDER_HOOKS_HOOKBEH_SUB_BEHAVIOURS_H
#define GLIDER_HOOKS_HOOKBEH_SUB_BEHAVIOURS_H

#include "hooks/hookbeh/args.h"
#include "hooks/hookbeh/command.h"
#include "hooks/hookbeh/hull.h"

/// The sub-behaviours that hookbeh generates, each a small value with its command for one cycle.
GLIDER_HOOKS_BEGIN

/// What the servo keeps the pitch of.
void hookServoCommand(double pitch_rad, double pump_cc, HookDoing doing,
                      HookVerticalCommand* command);

/// Sinks at a given pitch, negative, until `depth >= target`; or rises at a positive one until
/// `depth <= target`.
typedef struct HookSlope {
  double target_m;
  double pitch_rad;
} HookSlope;

void hookDiveToCommand(const HookSlope* dive, const HookbehArgs* args,
                       HookVerticalCommand* command);
void hookClimbToCommand(const HookSlope* climb, const HookbehArgs* args,
                        HookVerticalCommand* command);

/// Keeps the last commands until the SBC sends its next instruction.
typedef struct HookHold {
  HookVerticalCommand kept;
  double left_s;
} HookHold;

void hookHoldCommand(const HookHold* hold, HookVerticalCommand* command);

/// Rises to the surface and stays there.
void hookSurfaceCommand(const HookbehArgs* args, HookVerticalCommand* command);

/// Keeps pump and pitch battery where the SBC has commanded them: no depth, no pitch.
typedef struct HookFixedActuators {
  double pump_cc;
  double battery_in;
} HookFixedActuators;

/// A pump that is far in drives the vehicle down as a dive does, and what guards a dive guards
/// this. With less the vehicle may sink, rise or stay, by its trim, as in a hover.
bool hookActuatorsDive(const HookFixedActuators* actuators);
void hookActuatorsCommand(const HookFixedActuators* actuators, const HookbehArgs* args,
                          HookVerticalCommand* command);

/// The command with which hookbeh climbs by its own limits: the hull's full pump range, regardless
/// of the b_args for ordinary climbs.
void hookClimbNow(HookDoing doing, const HookbehArgs* args, const HookHull* hull,
                  HookVerticalCommand* command);

/// The magnitude of pitch if the SBC gives none: 26 degrees, as in the vendor's yo, limited to the
/// b_args.
double hookUsualPitch(const HookbehArgs* args);

GLIDER_HOOKS_END

#endif
