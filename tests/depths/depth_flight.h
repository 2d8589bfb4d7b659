// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/scenario/scenario.h"
#include "tests/unit/simulator/fake_sbc.h"

#include <cstdint>
#include <set>
#include <string>

namespace glider::tests {

/// The environment's number `name`, or `standard`.
uint64_t wantedNumber(const char* name, uint64_t standard);

using Plan = simulator::FakePilot::Plan;

/// The default scenario over `water_m` of water with `skeleton` as its mission file.
simulator::Scenario diveScenario(const std::string& skeleton, double water_m);
/// As scenarios/skeleton.mi, with this greatest depth, an abend 10 m below it, and pitches up to
/// 45 degrees.
std::string hookbehSkeleton(double greatest_m);
/// The layered control's own yo between 4 m and `bottom_m`, at 26 degrees, under the same abend.
std::string layeredSkeleton(double greatest_m, double bottom_m);

/// What came of a flight.
struct Dived {
  double deepest_m = 0;   ///< by the vehicle itself, not by its sensors
  double last_m = 0;      ///< where it was at the end
  std::set<int> guards;   ///< values of x_hook_guard that were seen, but 0
  double guarded_s = -1;  ///< when the first of them was
  /// Before it, the water held a dive, well above the bottom: the vehicle was heavy for 54 s, and
  /// in the last 24 s of them its true depth changed by less than 0.7 m. That looks like the
  /// bottom.
  bool water_held_it = false;
  int dives = 0;             ///< how often the vehicle turned from sinking to rising below 2 m
  double given_back_s = -1;  ///< when the SBC released control
  /// Of where the vehicle was and what its pump did in each cycle: two flights that are alike have
  /// the same, and hardly any others.
  uint64_t fingerprint = 0xcbf29ce484222325U;
  int contacts = 0;              ///< with the bottom
  double on_bottom_s = 0;        ///< the longest of them
  double clearance_m = 1e9;      ///< the least, under water
  std::string bottom_violation;  ///< by the campaign's check of the bottom; empty: none
};

/// Flies `plan` (null: no SBC on board) through the real protocol. `comes_back`: where the SBC's
/// power was cut, its program begins again with it and takes control.
Dived flyDive(const Plan* plan, simulator::Scenario scenario, uint64_t seed,
              bool comes_back = false);

}  // namespace glider::tests
