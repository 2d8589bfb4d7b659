// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#ifndef GLIDER_HOOKS_HOOKBEH_DEPTH_WATCH_H
#define GLIDER_HOOKS_HOOKBEH_DEPTH_WATCH_H

#include "hooks/hookbeh/command.h"
#include "hooks/hookbeh/depth_source.h"
#include "hooks/hookbeh/recent_depths.h"

GLIDER_HOOKS_BEGIN

/// Decides whether the vehicle's depth can be believed. Compares the depth sensor with its own
/// earlier readings, with what the vehicle was commanded to do, and with the CTD if there is one.
typedef struct HookDepthWatch {
  HookHull hull;
  HookDepthSource own;
  HookRecentDepths own_lately;  ///< a reading of the CTD may be some seconds old
  HookDepthSource ctd;
  bool ctd_is_new;             ///< it differs from the previous one
  bool ctd_jumped;             ///< and has not agreed since
  bool own_jumped;             ///< in the cycle before
  bool ctd_frozen;             ///< until it moves
  bool differs;                ///< the two differed when last compared
  double own_at_ctd_change_m;  ///< own depth when the CTD's last changed
  double ctd_at_own_change_m;  ///< CTD's depth when the own last changed
  bool ctd_known;              ///< it has agreed once: the vehicle carries one that works
  double agree_s;              ///< how long the two have agreed
  double disagree_s;
  double
      alive_s;  ///< how long the own sensor has worked: its readings changed, or the CTD's agreed
  bool frozen;
  HookGuard blind;   ///< why the depth is not believed; None: it is
  double quiet_s;    ///< while blind: how long no fault was seen
  double climbed_s;  ///< while blind: how long the pump was out
} HookDepthWatch;

void hookDepthWatchInit(HookDepthWatch* watch, const HookHull* hull);
/// Takes in one cycle, `step_s` after the previous one, in which the pump was commanded to
/// `pump_cc` by hookbeh; NaN if it commanded nothing. Must be called in every cycle.
void hookDepthWatchObserve(HookDepthWatch* watch, const HookSurroundings* now, double step_s,
                           double pump_cc);
/// Why the depth cannot be believed in this cycle; None if it can.
HookGuard hookDepthWatchDoubt(const HookDepthWatch* watch);
/// The vehicle's own depth, m; NaN while it cannot be believed.
double hookDepthWatchDepth(const HookDepthWatch* watch);
/// For limits, m: the newest depth of the vehicle's own sensor, also while its depth is not known;
/// or that of the CTD, if it is deeper, of this cycle, and from a CTD that works. NaN before the
/// vehicle's own first reading.
double hookDepthWatchDeepest(const HookDepthWatch* watch);
/// True if a new reading of the CTD, which changes, agrees in this cycle.
bool hookDepthWatchIsSeenByAnother(const HookDepthWatch* watch);
/// The CTD's depth if it is new in this cycle, m; else NaN.
double hookDepthWatchCtdDepth(const HookDepthWatch* watch);
/// Records that the CTD works, though it has never agreed.
void hookDepthWatchBelieveCtd(HookDepthWatch* watch);

GLIDER_HOOKS_END

#endif
