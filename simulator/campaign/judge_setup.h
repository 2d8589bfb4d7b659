// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/hookbeh/args.h"
#include "platforms/load/dictionary.h"
#include "platforms/load/platform.h"
#include "simulator/campaign/promises.h"
#include "simulator/scenario/scenario.h"

#include <memory>
#include <vector>

namespace glider::simulator {

/// What the checks of a flight need in addition to the flight itself.
struct JudgeSetup {
  Faults faults;
  Promise promise;
  hooks::HookbehArgs args;  ///< of the mission file's hookbeh
  bool has_hookbeh = false;
  bool has_ctd = true;
  bool only_hookbeh = true;  ///< no other behaviour in the mission file dives
  double overdepth_m = -1;   ///< of its abend; negative: none
  double undervolts = -1;    ///< the same
  double hull_m = 0;         ///< the vehicle's greatest depth
  double pump_cc = 0;        ///< the range of its pump
  std::shared_ptr<const platforms::Dictionary> dictionary;  ///< of its sensors; not null
  double cycle_s = 4;
  double turn_s = 120;  ///< from the command to climb until the vehicle climbs
  double slowest_climb_mps = 0.05;
  double mean_W = 0;  ///< of the same mission's flight without a fault; 0: not known
};

/// The kinds of faults that a scenario itself contains.
std::vector<FaultKind> kindsOf(const Faults& faults);

/// The time after which abend ends the mission, s; 0 without one.
double overtimeOf(const Scenario& scenario);

/// The setup for a flight of `scenario`, whose faults are of `kinds`.
JudgeSetup judgeSetup(const platforms::Platform& platform, const Scenario& scenario,
                      const std::vector<FaultKind>& kinds);

}  // namespace glider::simulator
