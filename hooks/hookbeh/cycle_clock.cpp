// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/hookbeh/cycle_clock.h"

#include "hooks/protocol/numbers.h"

namespace glider::hooks {
namespace {

/// What a control cycle takes: 4.0 to 4.5 s in real logs.
constexpr double kNominalSecs = 4.0;
/// A step that one clock alone tells of is believed up to so many times the nominal.
constexpr double kMostAlone = 2.0;
/// s; more counts as this even where both clocks agree: what makes them both (the processor's
/// clock) can be wrong too. So can one that is believed alone where cycles were missed.
constexpr double kMostSecs = 20.0;
/// s; two clocks that differ by less agree.
constexpr double kAgree = 1.0;
/// More cycles than these are not missed: the number is false.
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
  step_s_ = atMost(step, kMostSecs);
  mission_s_ = mission_s;
  wall_s_ = wall_s;
  cycle_ = cycle;
}

}  // namespace glider::hooks
