// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/oracles/battery_judge.h"

#include "hooks/hookbeh/hookbeh.h"
#include "vehicles/slocum/oracles/wrong_sensors.h"

#include <fmt/format.h>

namespace glider::slocum::oracles {

using hooks::HookState;

namespace {

constexpr double kBatteryAtSurface = 1;  // m
constexpr double kPowerTimes = 3;        // times the power of a flight without a fault
constexpr double kPowerMore = 8000;      // J: a few strokes of the pump at any time
constexpr double kVoltageFor = 60;       // s
constexpr double kVoltageError = 0.05;

}  // namespace

double BatteryJudge::wayUpJ(double depth_m) const {
  const double takes_s = s_.turn_s + depth_m / s_.slowest_climb_mps;
  return 2 * s_.pump_cc * (s_.pump_out_j_cc + s_.pump_out_j_cc_m * depth_m) + s_.loads_W * takes_s;
}

std::string BatteryJudge::judgeUse(const CycleView& view) const {
  return s_.mean_W > 0 && view.used_J > kPowerTimes * s_.mean_W * view.time_s + kPowerMore
             ? fmt::format("the batteries have given {:.0f} J, and {:.2f} W is usual", view.used_J,
                           s_.mean_W)
             : "";
}

std::string BatteryJudge::judgeVoltage(const CycleView& view) {
  const bool known = !isWrong(s_.faults, {"m_battery"}, view.time_s, kVoltageFor);
  const bool low =
      !view.aborted && known && s_.undervolts >= 0 && view.volts < s_.undervolts - kVoltageError;
  below_since_s_ = !low ? -1 : below_since_s_ < 0 ? view.time_s : below_since_s_;
  return low && view.time_s - below_since_s_ > kVoltageFor
             ? fmt::format("the mission goes on at {:.2f} V", view.volts)
             : "";
}

/// A vehicle that dives on must still be able to come up.
std::string BatteryJudge::judgeWayUp(const CycleView& view) const {
  const bool under_water = view.true_depth_m > kBatteryAtSurface;
  if (view.left_J <= 0 && (under_water || view.hook == HookState::Active)) {
    return "the batteries are empty";
  }
  const bool dives = under_water && !view.aborted && view.hookbeh != nullptr &&
                     view.hook == HookState::Active && !(view.hookbeh->pump_cc > 0);
  const double needs = wayUpJ(view.true_depth_m);
  return dives && view.left_J < needs
             ? fmt::format("dives at {:.1f} m with {:.0f} J left, and the way up takes {:.0f} J",
                           view.true_depth_m, view.left_J, needs)
             : "";
}

std::string BatteryJudge::cycle(const CycleView& view) {
  std::string use = judgeUse(view);
  std::string voltage = judgeVoltage(view);
  std::string way_up = judgeWayUp(view);
  return !use.empty() ? use : !voltage.empty() ? voltage : way_up;
}

}  // namespace glider::slocum::oracles
