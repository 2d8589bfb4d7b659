// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/hookbeh/cycle_clock.h"

#include "hooks/protocol/numbers.h"

namespace glider::hooks {
namespace {

/// Duration of a control cycle, s: 4.0 to 4.5 s in real logs.
constexpr double kNominalSecs = 4.0;
/// A step that only one clock reports is accepted up to this multiple of the nominal step.
constexpr double kMostAlone = 2.0;
/// s; a longer step is cut to this, even if both clocks agree: their common source (the processor's
/// clock) can be wrong too. So can a single clock that is accepted where cycles were missed.
constexpr double kMostSecs = 20.0;
/// s; no counted cycle is shorter.
constexpr double kLeastSecs = 0.5;
/// s; two clocks agree if they differ by at most this.
constexpr double kAgree = 1.0;
/// A jump by more cycles than this does not mean missed cycles: the number is false.
constexpr double kMostCycles = 5;

/// False for a NaN.
bool isStep(double step, double most) {
  return step > 0 && step <= most;
}

}  // namespace

void CycleClock::advance(double mission_s, double wall_s, double cycle) {
  const double by_mission = mission_s - mission_s_;
  const double by_wall = wall_s - wall_s_;
  const double cycles = cycle - cycle_;
  const double expected = kNominalSecs * (cycles <= kMostCycles ? atLeast(cycles, 1) : 1);
  const double most = kMostAlone * expected;
  const bool agree = magnitude(by_mission - by_wall) <= kAgree && by_mission > 0;
  const bool wall_is_nearer = !(magnitude(by_mission - expected) <= magnitude(by_wall - expected));
  follows_ = agree || isStep(by_mission, most);
  const bool mission_counts =
      isStep(by_mission, most) && !(isStep(by_wall, most) && wall_is_nearer);
  const double step = agree || mission_counts ? by_mission
                      : isStep(by_wall, most) ? by_wall
                                              : expected;
  const double least = cycles >= 1 && cycles <= kMostCycles ? kLeastSecs * cycles : 0;
  step_s_ = between(step, least, kMostSecs);
  mission_s_ = mission_s;
  wall_s_ = wall_s;
  cycle_ = cycle;
}

}  // namespace glider::hooks
