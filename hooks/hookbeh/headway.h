// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#ifndef GLIDER_HOOKS_HOOKBEH_HEADWAY_H
#define GLIDER_HOOKS_HOOKBEH_HEADWAY_H

#include "hooks/protocol/language.h"

/// Which way a sub-behaviour drives the vehicle.
#ifdef __cplusplus
enum class HookWay : uint8_t { None, Down, Up };
#else
typedef uint8_t HookWay;
enum { kHookWayNone, kHookWayDown, kHookWayUp };
#endif

GLIDER_HOOKS_BEGIN

/// Checks whether the vehicle moves in the direction in which it is driven.
typedef struct HookHeadway {
  HookWay way;
  double last_m;
  double best_m;
  double idle_s;    ///< since it was driven this way and last gained a metre
  double driven_s;  ///< this way
  double still_m;   ///< the depth has been near this one, and for how long
  double still_s;
} HookHeadway;

void hookHeadwayInit(HookHeadway* headway);
/// Takes in one cycle in which it was driven `way`.
void hookHeadwayObserve(HookHeadway* headway, HookWay way, double depth_m, double step_s);
/// A cycle in which the depth was not known, and hookbeh climbed.
void hookHeadwayInterrupt(HookHeadway* headway);
/// The depth at which a dive has stopped, as on the bottom, m: the pump has had the time to act,
/// and for a while the depth has not changed. NaN if it has not.
double hookHeadwayStandsAt(const HookHeadway* headway);
/// A dive that gains no depth has stopped: it has been driven down for a minute without a break,
/// or has gained nothing for three.
bool hookHeadwayMayHaveStopped(const HookHeadway* headway);

GLIDER_HOOKS_END

#endif
