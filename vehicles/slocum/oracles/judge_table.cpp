// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/oracles/judge_table.h"

#include "hooks/protocol/nap_times.h"
#include "simulator/campaign/judge_id.h"
#include "vehicles/slocum/oracles/judge_limits.h"
#include "vehicles/slocum/oracles/names.h"

#include <fmt/format.h>

namespace glider::slocum::oracles {

using namespace limits;

namespace {

constexpr int kCycleSecs = 4;  // of the platform

// size: a row for each check
std::string allowedBy(JudgeId judge) {
  switch (judge) {
    case JudgeId::Instructions:
      return "an instruction that is obeyed differently from what was sent, twice, or after "
             "control "
             "was released";
    case JudgeId::Times:
      return "control that does not end in the time that the first table states";
    case JudgeId::Handshake:
      return "an SBC that asks for control, with no fault in the last minute, and gets no answer "
             "for "
             "`silence_secs` and 8 cycles";
    case JudgeId::Commands:
      return "a command that is missing, outside the b_args, or not that of the instruction in "
             "force; "
             "no climb past a limit or by an implausible depth";
    case JudgeId::Guards:
      return "a guard that is missing, weak or reported wrongly; a heartbeat that counts wrongly";
    case JudgeId::Needless:
      return fmt::format(
          "more than {:.0f} climb of a guard an hour, and {:.0f} more, or over {:.0f} % "
          "of the time in control and {:.0f} s, although no limit was near and depth, "
          "CTD and echoes had been right for 5 min; not guard 5 while the depth is frozen",
          kNeedlessAnHour, kNeedlessMore, 100 * kNeedlessShare, kNeedlessSecs);
    case JudgeId::Depth:
      return fmt::format(
          "a true depth past the limit in force by more than the first table states. "
          "While the flight controller is down, a vehicle that dived sinks by up to "
          "{} m/s at 45 degrees, in proportion at smaller pitches but not less than at "
          "17 degrees, one that hovered by {} m/s; then {:.0f} m while it turns",
          kSinkMps, kLevelSinkMps, kTurnM);
    case JudgeId::Bottom:
      return fmt::format(
          "the bottom, if the altimeter receives an echo every {:.0f} s on average (if they are "
          "more than {:.0f} s apart, after {} of them, not in water of {:.0f} m, or `min_altitude` "
          "and {:.0f} m, or less, nor {:.0f} s or {:.0f} times that time under water after the "
          "last one); "
          "otherwise a second contact within {:.0f} m of an earlier one of {:.0f} s or more, or "
          "after {} shorter ones in deeper water, unless the bottom has risen "
          "by {:.0f} m; or over {:.0f} s on the bottom. With "
          "an altimeter that receives echoes also a clearance of over 4 m less than `min_altitude`",
          kEchoEverySecs, kRareEchoSecs, kEchoesToKnow, kShallowM, kOverShallowM, kEchoLastsSecs,
          kSilentGaps, kPlaceM, kNoticedSecs, kShortTouches, kRiseM, kOnBottomSecs);
    case JudgeId::Ascent:
      return "a vehicle that is still under water 120 s plus 20 s per metre after anything "
             "commanded "
             "a dive";
    case JudgeId::Battery:
      return "three times the energy that a flight without a fault uses in the same time, and 8 "
             "kJ; a "
             "mission that goes on below `undervolts`; a dive with less energy left than the way "
             "up "
             "takes; empty batteries under water or under control";
    case JudgeId::Pump:
      return fmt::format(
          "more than {:.0f} full strokes of the pump an hour, and {:.0f} more (apart from those "
          "that a mission commands while a sensor is wrong), or more than {:.0f} W, and {:.0f} kJ "
          "more",
          kStrokesAnHour, kStrokesMore, kPumpW, kPumpMoreJ / 1000);
    case JudgeId::Position:
      return fmt::format(
          "a vehicle under control that comes into water of less than {:.0f} m, or on "
          "land; one that floats without control and drifts more than {} m/s faster "
          "than the current; one that travels faster than the environment model allows",
          kShoreM, kDriftMps);
    case JudgeId::Surface:
      return fmt::format(
          "a vehicle that stays at the surface for over {:.0f} s, or in missions of over "
          "{:.0f} h for over {:.0f} % of the time, although the SBC has had control for {:.0f} s "
          "and commands a depth, the water is deep enough, and its readings have been right for "
          "{:.0f} min; not if the depth had jumped and no CTD has agreed with it since",
          kAtSurfaceSecs, kLongSecs / 3600, 100 * kSurfaceShare, kTakesHoldSecs, kRightSecs / 60);
    case JudgeId::Naps:
      return fmt::format(
          "an SBC that sleeps and changes its command, or the mission's state, more than {} s "
          "after the tick that decides it, unless a fault is of the line, a computer or a "
          "sensor that the mission does not read, or control was taken away",
          kHookMostWakeSecs + kHookReplaySecs + kCycleSecs);
    case JudgeId::Ending:
      return "a flight that does not end in time, ends under water, or without the exit of the "
             "mission "
             "where control is kept";
  }
  return "";
}

}  // namespace

std::string judgeTable() {
  std::string table;
  for (uint32_t i = 0; i < kJudges; ++i) {
    const auto judge = static_cast<JudgeId>(i);
    table += fmt::format("| {} | {} |\n", nameOf(judge), allowedBy(judge));
  }
  return table;
}

}  // namespace glider::slocum::oracles
