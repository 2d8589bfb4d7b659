// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#ifndef GLIDER_HOOKS_HOOKBEH_PILOT_H
#define GLIDER_HOOKS_HOOKBEH_PILOT_H

#include "hooks/hookbeh/args.h"
#include "hooks/hookbeh/command.h"
#include "hooks/hookbeh/headway.h"
#include "hooks/hookbeh/hover.h"
#include "hooks/hookbeh/sub_behaviours.h"
#include "hooks/protocol/instruction.h"

GLIDER_HOOKS_BEGIN

/// Turns the instruction in force into a sequence of sub-behaviours and runs them. Expects
/// instructions that passed hookbehCheckBounds().
typedef struct HookPilot {
  HookInstruction in_force;
  uint8_t stage;
  HookSlope dive;
  HookSlope climb;
  HookHold hold;
  HookHover hover;
  HookFixedActuators actuators;
} HookPilot;

void hookPilotInit(HookPilot* pilot);
/// A new session: nothing is in force but `instruction`.
void hookPilotBegin(HookPilot* pilot, const HookInstruction* instruction);
/// A further instruction. If its vertical part is None or equals the one in force, that part
/// changes nothing.
void hookPilotFollow(HookPilot* pilot, const HookInstruction* instruction);
/// The guard has stopped climbing: from its current depth the vehicle goes back to a depth that
/// it had reached before; a hover that has only checked its depth (`checked`) by its pump alone,
/// if that is near. Must be called before hookPilotVertical().
void hookPilotGoBack(HookPilot* pilot, const HookSurroundings* now, const HookbehArgs* args,
                     bool checked);
/// The commands for pitch and pump in this cycle, `step_s` after the previous one.
void hookPilotVertical(HookPilot* pilot, const HookSurroundings* now, double step_s,
                       const HookbehArgs* args, HookVerticalCommand* command);
/// Which way it drives the vehicle at `depth_m`. A hover drives it if it is farther from its
/// depth than its pump alone explains, and a commanded pump if it is far in.
HookWay hookPilotWay(const HookPilot* pilot, double depth_m);
void hookPilotLateral(const HookPilot* pilot, const HookSurroundings* now,
                      HookLateralCommand* command);

GLIDER_HOOKS_END

#endif
