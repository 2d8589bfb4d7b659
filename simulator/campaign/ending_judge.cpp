// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/campaign/ending_judge.h"

#include <fmt/format.h>

#include <algorithm>

namespace glider::simulator {

using hooks::HookState;

namespace {

constexpr double kAtSurface = 1;     // m
constexpr double kPowerTimes = 3;    // times the power of a flight without a fault
constexpr double kPowerMore = 8000;  // J: a few strokes of the pump at any time
constexpr double kVoltageFor = 60;   // s
constexpr double kVoltageError = 0.05;

}  // namespace

EndingJudge::EndingJudge(const JudgeSetup& setup)
    : s_(setup), voltage_known_(std::ranges::none_of(setup.faults.sensors, [](const auto& fault) {
        return fault.name == "m_battery";
      })) {}

std::string EndingJudge::judgeAscent(const CycleView& view) {
  const bool dives = !view.aborted && (view.hook == HookState::Active || !s_.only_hookbeh);
  if (dives || view.true_depth_m < kAtSurface) {
    up_by_s_ = -1;
    return "";
  }
  const double gap = view.time_s - last_s_;
  if (up_by_s_ < 0) {
    up_by_s_ = view.time_s + s_.turn_s + view.true_depth_m / s_.slowest_climb_mps;
  } else if (gap > 1.5 * s_.cycle_s) {
    up_by_s_ += gap;  // the flight controller did nothing meanwhile
  }
  return view.time_s <= up_by_s_
             ? ""
             : fmt::format("still {:.1f} m deep though nothing dives any more", view.true_depth_m);
}

std::string EndingJudge::judgeBattery(const CycleView& view) {
  if (s_.mean_W > 0 && view.used_J > kPowerTimes * s_.mean_W * view.time_s + kPowerMore) {
    return fmt::format("the batteries have given {:.0f} J, and {:.2f} W is usual", view.used_J,
                       s_.mean_W);
  }
  const bool low = !view.aborted && voltage_known_ && s_.undervolts >= 0 &&
                   view.volts < s_.undervolts - kVoltageError;
  below_since_s_ = !low ? -1 : below_since_s_ < 0 ? view.time_s : below_since_s_;
  return low && view.time_s - below_since_s_ > kVoltageFor
             ? fmt::format("the mission goes on at {:.2f} V", view.volts)
             : "";
}

std::string EndingJudge::cycle(const CycleView& view) {
  std::string ascent = judgeAscent(view);
  std::string battery = judgeBattery(view);
  last_s_ = view.time_s;
  return ascent.empty() ? battery : ascent;
}

}  // namespace glider::simulator
