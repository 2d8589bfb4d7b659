// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#ifndef GLIDER_HOOKS_HOOKBEH_CYCLE_CLOCK_H
#define GLIDER_HOOKS_HOOKBEH_CYCLE_CLOCK_H

#include "hooks/protocol/language.h"

GLIDER_HOOKS_BEGIN

/// Measures how long each control cycle took. Two clocks and the cycle number are compared with
/// each other, so that one false reading of any of them has no effect.
typedef struct HookCycleClock {
  double mission_s;
  double wall_s;
  double cycle;
  double step_s;  ///< since the previous cycle, s; above 0 and at most 20 for any readings of the
                  ///< clocks: timers must expire even if the clocks do not advance
  bool follows;   ///< the mission time of this cycle continues that of the previous cycle
} HookCycleClock;

void hookCycleClockInit(HookCycleClock* clock);
/// Takes in one cycle: m_present_secs_into_mission, m_present_time, m_cycle_number; NaN for
/// unknown.
void hookCycleClockAdvance(HookCycleClock* clock, double mission_s, double wall_s, double cycle);

GLIDER_HOOKS_END

#endif
