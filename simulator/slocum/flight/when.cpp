// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/slocum/flight/when.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <chrono>
#include <cmath>
#include <vector>

namespace glider::simulator {
namespace {

/// The seconds since 1970 of a stamp yymmddhhmm in UTC; NaN for one that is not a time.
double secondsOf(double stamp) {
  const auto digits = static_cast<int64_t>(stamp);
  const auto part = [&](int64_t unit) { return static_cast<int>(digits / unit % 100); };
  using namespace std::chrono;
  const year_month_day date{year(2000 + part(100'000'000)),
                            month(static_cast<unsigned>(part(1'000'000))),
                            day(static_cast<unsigned>(part(10'000)))};
  if (stamp < 0 || !date.ok() || part(100) > 23 || part(1) > 59) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const auto at = sys_days(date) + hours(part(100)) + minutes(part(1));
  return static_cast<double>(duration_cast<seconds>(at.time_since_epoch()).count());
}

/// The slots without a command: "heading or pitch".
std::string idleSlots(const Commands& below) {
  std::vector<std::string> slots;
  if (!below.heading) {
    slots.emplace_back("heading");
  }
  if (!below.pitch) {
    slots.emplace_back("pitch");
  }
  if (!below.pump_cc) {
    slots.emplace_back("pump");
  }
  return fmt::format("{}", fmt::join(slots, " or "));
}

}  // namespace

bool WhenCondition::isMode(const Situation& s) const {
  const auto mask = static_cast<uint64_t>(numbers_.secs());
  const bool set = (mask & static_cast<uint64_t>(s.mission_mode)) != 0;
  return stops_ ? !set : set;
}

/// When the time comes: a start before it does not count, one after it does. `when_secs`: 0 once,
/// at this time; negative once, then or later; otherwise also each period after it.
bool WhenCondition::isTime(const Situation& s) const {
  double due_s = secondsOf(numbers_.utc_stamp) - (s.utc_s - s.time_s);
  const double period_s = numbers_.secs();
  if (period_s < 0) {
    return s.time_s >= due_s && !has_started_;
  }
  if (period_s > 0 && s.time_s > due_s) {
    due_s += std::floor((s.time_s - due_s) / period_s) * period_s;
  }
  return s.time_s >= due_s && std::max(started_s_, ended_s_) < due_s;
}

bool WhenCondition::met(const Situation& s, const Commands& below) const {
  switch (code_) {
    case 0:
      return !stops_;  // as a stop_when: when the behaviour is complete
    case 1:
      return below.anyIdle();
    case 2:
      return !below.pitch;
    case 3:
      return !below.heading;
    case 4:
      return !below.pump_cc;
    case 6:
      return s.time_s - ended_s_ >= numbers_.secs();
    case 7:
      return s.waypoint_distance_m < numbers_.distance_m();
    case 8:
      return below.hit_waypoint;
    case 9:
      return s.time_s - started_s_ >= numbers_.secs();
    case 10:
      return s.time_s - started_s_ >= numbers_.secs() && !below.pump_cc;
    case 11:
      return s.science_wants_surface;
    case 12:
      return s.silent_s > numbers_.secs();
    case 13:
      return isTime(s);
    case 14:
      return below.hovering;
    case 15:
      return code_15_ == Code15::MissionMode ? isMode(s)
                                             : s.waypoint_distance_m > numbers_.distance_m();
    case 16:
      return s.inflections > numbers_.inflections;
    case 17:
      return s.primary_distance_m < numbers_.distance_m();
    case 18:
      return s.primary_distance_m > numbers_.distance_m();
    default:
      return false;  // 5: never
  }
}

/// What the code means, with its numbers.
std::string WhenCondition::meaning(const Commands& below) const {
  const double secs = numbers_.secs(), distance = numbers_.distance_m();
  switch (code_) {
    case 0:
      return stops_ ? "when it is complete" : "at once";
    case 1:
      return fmt::format("no behaviour below commands {}", idleSlots(below));
    case 2:
      return "no behaviour below commands pitch";
    case 3:
      return "no behaviour below commands heading";
    case 4:
      return "no behaviour below commands pump";
    case 6:
      return fmt::format("{} s after it ended", secs);
    case 7:
      return fmt::format("the waypoint is nearer than {} m", distance);
    case 8:
      return "a waypoint is reached";
    case 9:
      return fmt::format("every {} s", secs);
    case 10:
      return fmt::format("every {} s, when no behaviour below commands the pump", secs);
    case 11:
      return "the science computer asks for it";
    case 12:
      return fmt::format("no contact for {} s", secs);
    case 13:
      return fmt::format("at {:010.0f} UTC (yymmddhhmm){}", numbers_.utc_stamp,
                         secs > 0 ? fmt::format(" and every {} s after it", secs) : "");
    case 14:
      return "the vehicle hovers";
    case 15:
      return code_15_ == Code15::MissionMode
                 ? fmt::format("u_mission_mode has a bit of {}", secs)
                 : fmt::format("the waypoint is further away than {} m", distance);
    case 16:
      return fmt::format("more than {} inflections", numbers_.inflections);
    case 17:
      return fmt::format("the primary waypoint is nearer than {} m", distance);
    case 18:
      return fmt::format("the primary waypoint is further away than {} m", distance);
    default:
      return "never";
  }
}

std::string WhenCondition::text(const Commands& below) const {
  return fmt::format("{}: {}", code_, meaning(below));
}

}  // namespace glider::simulator
