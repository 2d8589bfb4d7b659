// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#ifndef GLIDER_HOOKS_HOOKBEH_HOVER_H
#define GLIDER_HOOKS_HOOKBEH_HOVER_H

#include "hooks/hookbeh/args.h"
#include "hooks/hookbeh/command.h"

GLIDER_HOOKS_BEGIN

/// Keeps a depth at level pitch by the pump: proportional to the error of the depth, damped by its
/// rate, both smoothed. The pump rests while its volume would change little: a stroke costs what
/// the rest of the vehicle takes in three minutes, and neither noise nor swell moves the vehicle.
typedef struct HookHover {
  double target_m;
  double read_m;  ///< the newest reading, and its age
  double age_s;
  double depth_m;   ///< smoothed, at the time of that reading
  double rate_mps;  ///< the same, positive when sinking
  double pump_cc;   ///< commanded last
} HookHover;

void hookHoverInit(HookHover* hover, double target_m);
/// The command in this cycle, `step_s` after the previous one; 0 while another behaviour has the
/// motors. A depth that is unknown brings the pump out.
void hookHoverCommand(HookHover* hover, const HookSurroundings* now, double step_s,
                      const HookbehArgs* args, HookVerticalCommand* command);

GLIDER_HOOKS_END

#endif
