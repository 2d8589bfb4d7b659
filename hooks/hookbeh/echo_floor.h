// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#ifndef GLIDER_HOOKS_HOOKBEH_ECHO_FLOOR_H
#define GLIDER_HOOKS_HOOKBEH_ECHO_FLOOR_H

#include "hooks/protocol/language.h"

GLIDER_HOOKS_BEGIN

/// How deep the bottom is at least, by the altimeter's echoes. While it receives none, the bottom
/// may rise as it did between the last echoes, and more; on the other hand an altimeter that would
/// have received an echo of a near bottom shows that there is none. How soon silence shows that
/// depends on how often it receives echoes.
typedef struct HookEchoFloor {
  bool heard;         ///< an echo came in this cycle
  double seen_m;      ///< the altitude in the sensor array
  double altitude_m;  ///< that of the newest echo
  double bottom_m;    ///< the bottom's depth by the newest echo; NaN before the first
  double floor_m;     ///< the least depth of the bottom now
  double silent_s;    ///< since the newest echo; NaN before the first
  double heard_at_m;  ///< depth of the vehicle then
  bool sank;          ///< the vehicle sank when the echoes ended
  double echoes;      ///< since silence last ruled out a bottom
  double missed;      ///< cycles since the newest echo in which there should have been one
  double listened;    ///< cycles without an echo at depths from this one on
  double least_m;
  double cleared_m;  ///< silence ruled out a bottom above this depth
  double gap;        ///< how many there are from echo to echo, on average
  double reach_m;    ///< from how far an echo has come
  double rise_mps;   ///< how fast the bottom has risen
  double anchor_m;   ///< an earlier echo, and its age
  double anchor_s;
} HookEchoFloor;

void hookEchoFloorInit(HookEchoFloor* echoes);
/// Takes in one cycle. `depth_m`: NaN while it is not believed. `least_m`: an old echo at the
/// surface may keep the floor as high as this, m.
void hookEchoFloorObserve(HookEchoFloor* echoes, double depth_m, double altitude_m, double least_m,
                          double step_s);
/// What the sensor array held before hookbeh began: an echo of an earlier time.
void hookEchoFloorIgnore(HookEchoFloor* echoes, double altitude_m);
/// It received many echoes, in most cycles, and then fell silent well within its range, or while
/// the vehicle sank towards the bottom: it has probably failed. Fewer may have been fish.
bool hookEchoFloorHasFailed(const HookEchoFloor* echoes);

GLIDER_HOOKS_END

#endif
