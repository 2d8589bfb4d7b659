// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What docs/at-the-surface.md says of a surfacing, rule by rule, in flights.

#include "tests/flights/flight.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>
#include <string>

namespace glider::tests {
namespace {

using testing::HasSubstr;

/// A behaviour `surface` with these lines.
std::string surface(const std::string& arguments) {
  return "\nbehavior: surface\n" + arguments + "    b_arg: gps_wait_time(s) 300\n";
}

std::string argument(const std::string& name, int value) {
  return "    b_arg: " + name + "(s) " + std::to_string(value) + "\n";
}

/// The mission goes up every 40 min, and says when it has a fix and when it is masked.
constexpr const char* kSurfacing = R"(mission surfacing
state dive
begin
  flightroute   heading(90 deg)
  flightprofile yo(5 m, 30 m, 26 deg, 26 deg)
  sensors       missiontime, depth, x_hook_masked, m_gps_lat
  events
    case missiontime > 3 h                                              exit
    case became(x_hook_masked > 0)        do log "masked", missiontime end stay
    case became(x_hook_masked < 1)        do log "free", missiontime   end stay
    case resumetime > 40 min call up
end
state up
begin
  flightprofile surfaced
  sensors       depth, statetime, m_gps_lat, m_depth_state
  events
    case became(at_surface && age(m_gps_lat) < 6 s) do log "fix", statetime end stay
    case held(at_surface, 3 min) || statetime > 20 min return
end
)";

/// Flies it with a mission file whose first `surface` has these lines.
Flight flyWith(const std::string& first, const std::string& faults = "", int overtime = 43200) {
  const TemporaryFolder folder;
  (void)folder.write("skeleton.mi",
                     "behavior: abend\n" + argument("overtime", overtime) +
                         argument("overdepth", 70) + surface(first) +
                         surface(argument("start_when", 1) + argument("end_action", 2)) +
                         "\nbehavior: hookbeh\n    b_arg: max_depth(m) 60\n");
  const auto scenario = folder.write("s.toml", slurp(project("scenarios/default.toml")) + faults);
  return fly(folder.write("m.mission", kSurfacing).string() + " --scenario " + scenario.string());
}

/// The times of the vehicle at which an event with this text happens.
std::vector<double> timesOf(const Flight& flight, const std::string& text) {
  std::vector<double> times;
  for (const Event& event : flight.events) {
    if (event.what.find(text) != std::string::npos) {
      times.push_back(event.time_s);
    }
  }
  return times;
}

const std::string kNoContact =
    argument("start_when", 12) + argument("when_secs", 4500) + argument("keystroke_wait_time", 300);

/// Rules 6 to 8.
TEST(Surfacing, OfTheMissionHasAFixButNoContact) {
  const Flight flight = flyWith(kNoContact + argument("end_action", 2));
  const auto fixes = timesOf(flight, "fix"), calls = timesOf(flight, "surface_2 started");
  ASSERT_GE(fixes.size(), 2U);
  ASSERT_GE(calls.size(), 1U);
  EXPECT_LT(fixes[0], 4500) << "the mission was up before";
  EXPECT_NEAR(calls[0], 4508, 8) << "and yet there was no contact";
  // From the antenna's arrival to the fix.
  const auto depth = flight.column("true_depth"), time = flight.column("time");
  for (const double fix : fixes) {
    double arrived = 0;
    for (size_t i = 0; i < time.size() && time[i] < fix; ++i) {
      arrived = depth[i] > 0.3 ? time[i] : arrived;
    }
    EXPECT_NEAR(fix - arrived, 24, 8);
  }
}

/// Rules 2, 9, 10, 12 and 14.
TEST(Surfacing, OfTheVehicleWaitsForAKeyAndResumesWhenNobodyAnswers) {
  const Flight waits = flyWith(kNoContact + argument("end_action", 1));
  const Flight resumes = flyWith(kNoContact + argument("end_action", 2));
  const auto up = [](const Flight& flight) {
    const auto began = timesOf(flight, "surface_2 started"),
               ended = timesOf(flight, "surface_2 done");
    return began.empty() || ended.empty() ? 0 : ended[0] - began[0];
  };
  EXPECT_GT(up(resumes), 20);
  EXPECT_NEAR(up(waits) - up(resumes), 300, 8) << "keystroke_wait_time";
  EXPECT_EQ(timesOf(waits, "masked ").size(), timesOf(waits, "free ").size());
  EXPECT_EQ(waits.transitions().back().what, "dive → end (exit)");
}

/// Rule 10.
TEST(Surfacing, ThatQuitsEndsTheControlOfTheSbc) {
  for (const int action : {0, 5}) {
    const Flight flight = flyWith(kNoContact + argument("end_action", action));
    for (const Event& event : flight.transitions()) {
      EXPECT_EQ(event.what.find("exit"), std::string::npos) << action;
      EXPECT_LT(event.time_s, 6200) << action;
    }
    EXPECT_LT(flight.column("time").back(), 6200) << action;
  }
}

/// Rule 8: what the vehicle's own surfacing counts as contact is not due again for `when_secs`.
TEST(Surfacing, OfTheVehicleIsAContact) {
  const auto calls = timesOf(
      flyWith(argument("start_when", 12) + argument("when_secs", 3000) + argument("end_action", 2)),
      "surface_2 started");
  ASSERT_GE(calls.size(), 3U);
  EXPECT_GT(calls[1] - calls[0], 3000);
  EXPECT_LT(calls[1] - calls[0], 4000);
}

/// Rule 4.
TEST(Surfacing, AfterAnAbortTheMissionGetsNoControl) {
  const Flight flight = flyWith(kNoContact + argument("end_action", 2), "", 4000);
  EXPECT_THAT(flight.outcome.err, HasSubstr("OVERTIME"));
  for (const Event& event : flight.events) {
    if (event.time_s > 4004) {
      EXPECT_EQ(event.what.find("takes control"), std::string::npos) << event.time_s;
    }
  }
  EXPECT_EQ(flight.valueAt("hook_active", 4100), 0);
  EXPECT_LT(flight.column("true_depth").back(), 0.5);
}

/// Rule 14: a case with `statetime` fires while the vehicle waits at the surface.
TEST(Surfacing, TheClocksOfTheMissionGoOn) {
  const Flight flight = flyWith(argument("start_when", 12) + argument("when_secs", 1500) +
                                argument("end_action", 1) + argument("keystroke_wait_time", 3000));
  const auto up = flight.transitions();
  ASSERT_FALSE(up.empty());
  EXPECT_EQ(up[0].what, "dive → up (call)");
  EXPECT_NEAR(up[0].mission_time_s, 2404, 4) << "40 min after the start";
  EXPECT_LT(flight.valueAt("true_depth", up[0].time_s), 0.5) << "it waits for a key meanwhile";
}

/// Rule 3.
TEST(Surfacing, FollowsTheSilenceOfTheSbc) {
  const Flight flight = flyWith(kNoContact + argument("end_action", 2), R"(
[[faults.power]]
from_s = 1000
to_s = 20000
)");
  const auto surfacings = timesOf(flight, "surface_3 started");
  ASSERT_FALSE(surfacings.empty());
  EXPECT_LT(surfacings[0], 1000 + 24 + 3 * 4);
  EXPECT_LT(flight.valueAt("true_depth", 1600), 0.5);
}

}  // namespace
}  // namespace glider::tests
