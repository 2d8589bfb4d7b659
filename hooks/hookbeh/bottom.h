// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#ifndef GLIDER_HOOKS_HOOKBEH_BOTTOM_H
#define GLIDER_HOOKS_HOOKBEH_BOTTOM_H

#include "hooks/hookbeh/bottom_memory.h"
#include "hooks/hookbeh/command.h"
#include "hooks/hookbeh/echo_floor.h"

GLIDER_HOOKS_BEGIN

/// Where the bottom is, from the altimeter's echoes and from contacts: a dive that stops, from
/// whose depth the vehicle then climbs as its depth shows.
typedef struct HookBottom {
  HookEchoFloor echoes;
  HookBottomMemory memory;
  double depth_m;
  double dive_m;       ///< the greatest depth of the newest dive
  bool sinks;          ///< it has not turned
  double top_m;        ///< the least depth since it did
  double stop_m;       ///< where a dive stopped; NaN if none has to be confirmed
  double stop_last_m;  ///< the newest depth since then, and its age
  double stop_gap_s;
  double stop_age_s;     ///< since that stop
  double stop_far_m;     ///< how far the depth has been from it since then
  double stuck_m;        ///< a depth that follows no climb; NaN: none
  bool believed;         ///< the altimeter: no contact contradicts it
  double agrees_from_m;  ///< range of depths at which it agreed with a contact
  double agrees_to_m;
  double agreed;  ///< how many echoes did
  bool failed;
} HookBottom;

void hookBottomInit(HookBottom* bottom);
/// Where the vehicle is; must be called before hookBottomObserve(), apart from it for the sake of
/// the stack.
void hookBottomMove(HookBottom* bottom, const HookSurroundings* now, double least_altitude_m,
                    double step_s);
/// Takes in one cycle, `step_s` after the previous one. `depth_m`: NaN while it is not believed.
/// `least_altitude_m`: how far the vehicle stays above the bottom.
void hookBottomObserve(HookBottom* bottom, const HookSurroundings* now, double depth_m,
                       double least_altitude_m, double step_s);
/// Follows the dives, and confirms a stop once the depth has followed the climb: a depth sensor
/// that is stuck would not. Must be called after hookBottomObserve().
void hookBottomFollow(HookBottom* bottom, double step_s);
/// A dive stopped in this cycle, and the vehicle climbs from now on. Where the depth did not
/// follow the climb after the stop before it is stuck, and no stop counts until it has moved.
void hookBottomNoteStop(HookBottom* bottom);
/// The least depth of the bottom where the vehicle is now, m; kHookBottomless if nothing is known.
double hookBottomFloor(const HookBottom* bottom);
/// The same by contacts alone, for a vehicle that uses no altimeter.
double hookBottomTouchedFloor(const HookBottom* bottom);

GLIDER_HOOKS_END

#endif
