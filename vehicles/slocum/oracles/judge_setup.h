// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/hookbeh/args.h"
#include "platforms/load/dictionary.h"
#include "platforms/load/platform.h"
#include "simulator/campaign/promises.h"
#include "simulator/scenario/scenario.h"
#include "vehicles/slocum/oracles/names.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

namespace glider::slocum::oracles {

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
  double line_lag_s = 8;       ///< of the line between the vehicle's computers, at most
  double longest_cycle_s = 4;  ///< of a running flight controller
  double turn_s = 120;         ///< from the command to climb until the vehicle climbs
  double slowest_climb_mps = 0.05;
  double mean_W = 0;   ///< of the same mission's flight without a fault; 0: not known
  double loads_W = 0;  ///< what all loads but the motors draw at most
  double pump_out_j_cc = 0, pump_out_j_cc_m = 0;  ///< as in the power table
  double current_mps = 0;                         ///< the fastest of the scenario
  double late_m = 0;             ///< how far it sinks until a pressure that is read seldom shows it
  double through_water_mps = 1;  ///< horizontally, at most
  double echo_every_s = 4;       ///< of the altimeter within its range, on average, without a fault
  /// What holds while no sensor of the vehicle is wrong; empty: as `promise`.
  std::optional<Promise> whole;

  /// How long hookbeh may wait for a sign of the SBC's life, s. If it dies in a nap, the beats on
  /// its behalf count for `nap_secs`; of a mission that never naps that is more than is needed.
  /// What a mission decides later after a nap does not count here: the lag is in no promise of
  /// control.
  [[nodiscard]] double silentAfter() const { return args.silence_secs + args.nap_secs; }
  /// The times of control, as the SBC sees them.
  [[nodiscard]] ControlTimes controlTimes() const { return {silentAfter(), cycle_s, line_lag_s}; }
  /// The same as hookbeh sees them: after the line.
  [[nodiscard]] ControlTimes hookbehTimes() const { return {silentAfter(), cycle_s, 0}; }
  /// What must hold at `now_s`. Before the first sensor is wrong, and some time after the last one,
  /// it is what holds without that fault; but what a mission does may depend on what it has read.
  [[nodiscard]] Promise promiseAt(double now_s) const;
  /// True if the flight controller was not running in a time without cycles of `gap_s`.
  [[nodiscard]] bool isDark(double gap_s) const {
    return gap_s > std::max(3 * cycle_s, longest_cycle_s + cycle_s);
  }
};

/// The setup for a flight of `scenario`, whose faults are of `kinds`.
JudgeSetup judgeSetup(const platforms::Platform& platform, const Scenario& scenario,
                      const std::vector<FaultKind>& kinds);

}  // namespace glider::slocum::oracles
