// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The SBC and the flight controller restart at every ten seconds of a mission. What is proved about
// the mission holds in the whole deployment, counted here without the mission's own monitors.

#include "tests/restarts/restart_flight.h"
#include "tests/support/command.h"
#include "tests/world/fleet.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <gmock/gmock.h>

namespace glider::tests {
namespace {

using testing::HasSubstr;

constexpr double kExit = 20 * 60;  ///< of the mission below, s

/// It dives deep once, in the middle; before and after it is shallow.
std::string onceDeep(const std::string& resumption) {
  return "mission once\n" + resumption + R"(
require visit deep at most 1 times
require exit within 30 min
require in ready: never depth > 8 m
var went : bool = false
state ready
begin
  flightprofile surfaced
  sensors       statetime
  events
    case statetime >= 1 min goto shallow
end
state shallow
begin
  flightprofile yo(4 m, 12 m, 26 deg, 26 deg)
  sensors       missiontime
  events
    case missiontime >= 5 min && !went do set went = true end goto deep
    case missiontime >= 20 min exit
end
state deep
begin
  flightprofile yo(5 m, 20 m, 26 deg, 26 deg)
  sensors       statetime
  events
    case statetime >= 5 min goto shallow
end
)";
}

/// What restarts, from a time on.
struct Kind {
  const char* name;
  std::function<simulator::Faults(double)> at;
  /// A restart of the flight controller after the exit begins another mission, s.
  double latest = kExit;
};

simulator::Faults faults(std::vector<simulator::Span> power,
                         const std::vector<simulator::Span>& flight) {
  simulator::Faults all;
  all.power = std::move(power);
  for (const simulator::Span& span : flight) {
    all.flight.push_back({span, false});
  }
  return all;
}

const Kind kKinds[] = {
    {"the flight controller in an outage",
     [](double t) { return faults({{t, t + 40}}, {{t + 5, t + 25}}); }},
    {"the flight controller alone", [](double t) { return faults({}, {{t, t + 20}}); }},
    {"the flight controller, then the SBC",
     [](double t) { return faults({{t + 10, t + 40}}, {{t, t + 20}}); }},
    {"the SBC, then the flight controller",
     [](double t) { return faults({{t, t + 20}}, {{t + 10, t + 30}}); }},
    {"both, three times",
     [](double t) {
       return faults({{t, t + 30}, {t + 100, t + 130}, {t + 300, t + 330}},
                     {{t + 5, t + 25}, {t + 105, t + 125}, {t + 305, t + 325}});
     },
     kExit - 330},
    {"both, for long",
     [](double t) { return faults({{t, t + 700}}, {{t + 5, t + 25}, {t + 300, t + 330}}); }},
    {"the SBC for long", [](double t) { return faults({{t, t + 700}}, {}); }},
};

class Restarts : public testing::TestWithParam<const char*> {};

TEST_P(Restarts, WhatIsProvedHoldsInTheWholeDeployment) {
  const TemporaryFolder folder;
  const std::string text = onceDeep(GetParam());
  const auto file = folder.write("once.mission", text);
  const Outcome checked = runShell("$GLIDERCC check --report " + file.string());
  for (const char* proved :
       {"proved: require visit deep at most 1 times", "proved: require exit within 30 min",
        "proved: require in ready: never depth > 8 m"}) {
    ASSERT_THAT(checked.out, HasSubstr(proved));
  }
  const FlyingMission mission = loadText(text);
  const auto every = static_cast<double>(wanted("GLIDER_RESTARTS_EVERY", 70));
  size_t resumed = 0;
  size_t over = 0;
  for (const Kind& kind : kKinds) {
    for (double at = 30; at < kind.latest; at += every) {
      const RestartFlight flight = flyRestarts(mission, kind.at(at), 5000);
      const std::string what = fmt::format("{} at {} s", kind.name, at);
      EXPECT_LE(flight.visits("deep"), 1U) << what;
      EXPECT_LE(flight.flown(), 30 * 60 + 60) << what;
      EXPECT_LE(flight.deepestIn("ready"), 8) << what;
      EXPECT_LT(flight.trace.at(flight.trace.rowCount() - 1, flight.trace.column("true_depth")), 1)
          << what;
      for (const auto& violation : flight.violations) {
        ADD_FAILURE() << what << ": requirement " << violation.number << ", at "
                      << violation.mission_time << " s, " << violation.after;
      }
      resumed += flight.flown() > kExit - 60 ? 1U : 0U;
      over += flight.flown() < kExit - 60 ? 1U : 0U;
    }
  }
  EXPECT_GT(resumed, 0U);
  EXPECT_GT(over, 0U);
}

/// The flight controller is down from 1000 to 1260 s, and the SBC for half a minute of that: until
/// then its mission goes on by its own clock, so only the rest is an outage.
TEST(RestartClock, CountsAnOutageOnce) {
  const FlyingMission mission = loadText(
      "mission clock\nstate a\nbegin\n  flightprofile yo(4 m, 12 m, 26 deg, 26 deg)\n"
      "  sensors missiontime\n  events\n    case missiontime >= 40 min exit\nend\n");
  const RestartFlight flight = flyRestarts(mission, faults({{1150, 1180}}, {{1000, 1260}}), 5000);
  const auto exit = std::ranges::find(flight.trace.events, support::EventId::MissionEnds,
                                      &support::TraceEvent::id);
  ASSERT_NE(exit, flight.trace.events.end());
  EXPECT_NEAR(exit->time_s, 40 * 60 + 4, 16);
}

INSTANTIATE_TEST_SUITE_P(Missions, Restarts,
                         testing::Values("", "resume within 5 min, never after restart",
                                         "resume within 20 s"));

TEST(Restarts, AMissionThatMayNotContinueIsOverAndTheVehicleStaysUp) {
  const FlyingMission mission = loadText(onceDeep("resume within 5 min, never after restart"));
  const RestartFlight flight = flyRestarts(mission, kKinds[0].at(500), 5000);
  EXPECT_EQ(flight.count("the mission is over: the vehicle has restarted"), 1U);
  EXPECT_EQ(flight.count(support::EventId::SbcTakesControl), 1U);
}

/// Whole blocks of the card read zero, so that the program finds nothing.
TEST(Restarts, AMissionThatHasLostItsCheckpointsBeginsAgainAtTheSurface) {
  const FlyingMission mission = loadText(onceDeep(""));
  for (double at = 100; at < kExit; at += 130) {
    simulator::Faults lost = kKinds[0].at(at);
    lost.card.push_back({at + 1, simulator::CardFault::Kind::Cut, 0});
    const RestartFlight flight = flyRestarts(mission, lost, 5000);
    EXPECT_LE(flight.deepestIn("ready"), 8) << at;
    EXPECT_EQ(flight.count(support::EventId::SbcTakesControl), 2U) << at;
    EXPECT_TRUE(flight.violations.empty()) << at;
  }
}

TEST(Restarts, AfterItsEndARestartUnderWaterDoesNotBeginTheMissionThere) {
  const FlyingMission mission = loadText(R"(mission quick
require in ready: never depth > 8 m
state ready
begin
  flightprofile surfaced
  sensors       statetime
  events
    case statetime >= 10 s goto down
end
state down
begin
  flightprofile yo(30 m, 40 m, 26 deg, 26 deg)
  sensors       missiontime
  events
    case missiontime >= 3 min exit
end
)");
  for (double at = 190; at < 400; at += 10) {
    const RestartFlight flight = flyRestarts(mission, kKinds[0].at(at), 2000);
    EXPECT_LE(flight.deepestIn("ready"), 8) << at;
    EXPECT_TRUE(flight.violations.empty()) << at;
  }
}

}  // namespace
}  // namespace glider::tests
