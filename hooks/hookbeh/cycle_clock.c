// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/hookbeh/cycle_clock.h"

#include "hooks/protocol/numbers.h"

/// Duration of a control cycle, s: 4.0 to 4.5 s in real logs.
static const double kNominalSecs = 4.0;
/// A step that only one clock reports is accepted up to this multiple of the nominal step.
static const double kMostAlone = 2.0;
/// s; a longer step is cut to this, even if both clocks agree: their common source (the processor's
/// clock) can be wrong too. So can a single clock that is accepted where cycles were missed.
static const double kMostSecs = 20.0;
/// s; no counted cycle is shorter.
static const double kLeastSecs = 0.5;
/// s; two clocks agree if they differ by at most this.
static const double kAgree = 1.0;
/// A jump by more cycles than this does not mean missed cycles: the number is false.
static const double kMostCycles = 5;

void hookCycleClockInit(HookCycleClock* clock) {
  clock->mission_s = clock->wall_s = clock->cycle = hookUnknown();
  clock->step_s = 0;
  clock->follows = false;
}

/// False for a NaN.
static bool isStep(double step, double most) {
  return step > 0 && step <= most;
}

void hookCycleClockAdvance(HookCycleClock* clock, double mission_s, double wall_s, double cycle) {
  const double by_mission = mission_s - clock->mission_s;
  const double by_wall = wall_s - clock->wall_s;
  const double cycles = cycle - clock->cycle;
  const double expected = kNominalSecs * (cycles <= kMostCycles ? hookAtLeast(cycles, 1) : 1);
  const double most = kMostAlone * expected;
  const bool agree = hookMagnitude(by_mission - by_wall) <= kAgree && by_mission > 0;
  const bool wall_is_nearer =
      !(hookMagnitude(by_mission - expected) <= hookMagnitude(by_wall - expected));
  clock->follows = agree || isStep(by_mission, most);
  const bool mission_counts =
      isStep(by_mission, most) && !(isStep(by_wall, most) && wall_is_nearer);
  const double step = agree || mission_counts ? by_mission
                      : isStep(by_wall, most) ? by_wall
                                              : expected;
  const double least = cycles >= 1 && cycles <= kMostCycles ? kLeastSecs * cycles : 0;
  clock->step_s = hookBetween(step, least, kMostSecs);
  clock->mission_s = mission_s;
  clock->wall_s = wall_s;
  clock->cycle = cycle;
}
