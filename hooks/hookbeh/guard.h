// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#ifndef GLIDER_HOOKS_HOOKBEH_GUARD_H
#define GLIDER_HOOKS_HOOKBEH_GUARD_H

#include "hooks/hookbeh/args.h"
#include "hooks/hookbeh/bottom.h"
#include "hooks/hookbeh/command.h"
#include "hooks/hookbeh/depth_watch.h"
#include "hooks/hookbeh/headway.h"
#include "hooks/hookbeh/unseen_sink.h"
#include "hooks/protocol/instruction.h"

GLIDER_HOOKS_BEGIN

/// hookbeh's own check of depth and altitude: decides when it must climb against any instruction of
/// the SBC.
typedef struct HookbehGuard {
  HookDepthWatch watch;
  HookHeadway headway;
  HookUnseenSink unseen;
  HookUnseenSink by_ctd;
  HookBottom bottom;
  double floor_m;          ///< of this cycle: by all that is known of the bottom
  double touched_floor_m;  ///< by contacts alone
  bool shows;              ///< it climbs to see whether its depth follows
  bool asks;               ///< the same, though another sensor agrees with it
  bool doubted;            ///< it climbed in the previous cycle: the depth was unknown or jumped
  double sinks_mps;
  double depth_m;  ///< for limits: hookDepthWatchDeepest()
  HookGuard tripped;
  double tripped_depth_m;  ///< the shallowest at which a limit was broken
  double tripped_s;        ///< since then
  double tries_after_s;    ///< a depth that repeats its zero after that time
  double down_from_m;      ///< how deep it may have been before it was driven down
} HookbehGuard;

void hookbehGuardInit(HookbehGuard* guard, const HookHull* hull);
/// Takes in one cycle, `step_s` after the previous one, in which hookbeh had commanded `last`
/// (pump NaN: it commanded nothing) and drove the vehicle `way`. Must be called in every cycle,
/// also while another behaviour is in control, so that the bottom is known when it matters.
void hookbehGuardObserve(HookbehGuard* guard, const HookbehArgs* args, const HookSurroundings* now,
                         double step_s, const HookVerticalCommand* last, HookWay way);
/// Why hookbeh must climb now, or None. Once too deep or too near the bottom it returns that
/// until the vehicle is a metre clear of the limits and `in_force` leads up or to a depth that is
/// a metre clear too; or until it has climbed half of the depth where the limit was broken, at
/// least 5 m: then the dive may be tried again, down to the limit. A depth that cannot be
/// believed is a reason until it can be believed.
HookGuard hookbehGuardMustClimb(HookbehGuard* guard, const HookbehArgs* args,
                                const HookInstruction* in_force);
/// The vehicle must climb to see whether its depth follows: it may have sunk to its limit without
/// the depth showing it, and no instruction moves it. Must be called after hookbehGuardMustClimb()
/// in each cycle in which hookbeh commands.
bool hookbehGuardMustShowDepth(HookbehGuard* guard, const HookbehArgs* args,
                               const HookInstruction* in_force);
/// Another SBC takes over: limits that the previous one broke are forgotten; the bottom and
/// faults of the depth are not.
void hookbehGuardReset(HookbehGuard* guard);

GLIDER_HOOKS_END

#endif
