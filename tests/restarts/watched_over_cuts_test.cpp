// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Requirements and assumptions are watched over power cuts of the SBC, with what the mission knew.

#include "tests/restarts/restart_flight.h"
#include "tests/world/fleet.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>

namespace glider::tests {
namespace {

using testing::HasSubstr;

/// States a and b in turn, five minutes each, for an hour; b is deeper in its second half hour.
FlyingMission inTurn(const std::string& head) {
  return loadText("mission turns\n" + head + R"(
var turns : number = 0 in 0 .. 20
state a
begin
  flightprofile yo(4 m, 10 m, 26 deg, 26 deg)
  sensors       missiontime, statetime, depth
  events
    case missiontime >= 1 h exit
    case statetime >= 5 min && turns < 20 do set turns = turns + 1 end goto b
end
state b
begin
  flightprofile yo(4 m, 14 m, 26 deg, 26 deg)
  sensors       missiontime, statetime, depth
  events
    case statetime >= 5 min goto a
end
)");
}

simulator::Faults cuts(std::vector<simulator::Span> power) {
  simulator::Faults faults;
  faults.power = std::move(power);
  return faults;
}

constexpr double kFlight = 6000;  ///< s

TEST(WatchedOverCuts, WhatHappensOnlyAfterTheCutIsReportedWithIt) {
  const FlyingMission mission =
      inTurn("require always depth <= 12 m || missiontime < 40 min\nrequire stack <= 2\n");
  const RestartFlight flight = flyRestarts(mission, cuts({{1500, 1540}}), kFlight);
  ASSERT_EQ(flight.violations.size(), 1U);
  EXPECT_EQ(flight.violations[0].number, 0U);
  EXPECT_GE(flight.violations[0].mission_time, 2400);
  EXPECT_THAT(flight.violations[0].after,
              HasSubstr("after an outage of the SBC from mission time"));
}

TEST(WatchedOverCuts, OneBeforeTheCutNamesNone) {
  const RestartFlight flight =
      flyRestarts(inTurn("require always depth <= 12 m\n"), cuts({{1500, 1540}}), kFlight);
  ASSERT_EQ(flight.violations.size(), 1U);
  EXPECT_LT(flight.violations[0].mission_time, 1500);
  EXPECT_EQ(flight.violations[0].after, "");
}

/// b is entered at 300, 900, 1500, 2100, 2700 and 3300 s.
TEST(WatchedOverCuts, VisitsBeforeAndAfterTheCutAreCountedTogether) {
  for (const double at : {1100.0, 1510.0, 2000.0}) {
    const RestartFlight flight =
        flyRestarts(inTurn("require visit b at most 4 times\n"), cuts({{at, at + 30}}), kFlight);
    ASSERT_EQ(flight.violations.size(), 1U) << at;
    EXPECT_NEAR(flight.violations[0].mission_time, 2700, 120) << at;
  }
}

TEST(WatchedOverCuts, NothingIsCountedTwice) {
  for (double at = 880; at < 980; at += 7) {
    const RestartFlight flight = flyRestarts(inTurn("require visit b at most 6 times\n"),
                                             cuts({{at, at + 9}, {at + 30, at + 70}}), kFlight);
    EXPECT_TRUE(flight.violations.empty()) << at;
    EXPECT_EQ(flight.visits("b"), 6U) << at;
  }
}

/// The newest checkpoints are lost: the mission enters b once more, from what it knew before.
TEST(WatchedOverCuts, WhatAMissionDoesTwiceFromAnOlderCheckpointCountsOnce) {
  size_t twice = 0;
  for (uint32_t lost = 1; lost < 40; ++lost) {
    // A while after one of the times at which it goes to b: whether the newest checkpoint is in the
    // part of the card that is lost depends on how many were written.
    const double at_s = 906 + 600.0 * (lost % 5);
    simulator::Faults faults = cuts({{at_s + lost % 4, at_s + 20}});
    if (lost % 2 == 0) {
      faults.power.insert(faults.power.begin(), {at_s - 60 - lost % 7, at_s - 40});
    }
    faults.card.push_back(
        {at_s + 6, simulator::CardFault::Kind::Cut, 0.2 + 0.01 * static_cast<double>(lost)});
    const RestartFlight flight =
        flyRestarts(inTurn("require visit b at most 6 times\n"), faults, kFlight);
    EXPECT_TRUE(flight.violations.empty()) << lost;
    twice += flight.visits("b") > 6 && flight.count("the mission waits") == 0 ? 1U : 0U;
  }
  EXPECT_GT(twice, 0U) << "no flight returned to an older checkpoint";
}

TEST(WatchedOverCuts, SeveralCutsAreAllNamed) {
  const RestartFlight flight = flyRestarts(inTurn("require visit b at most 5 times\n"),
                                           cuts({{500, 520}, {1200, 1300}, {2000, 2060}}), kFlight);
  ASSERT_EQ(flight.violations.size(), 1U);
  EXPECT_THAT(flight.violations[0].after, HasSubstr("after 3 outages of the SBC, the last from"));
}

TEST(WatchedOverCuts, TheTimeOfTheOutageCounts) {
  const FlyingMission mission = inTurn("resume within 15 min\nrequire exit within 70 min\n");
  const RestartFlight late = flyRestarts(mission, cuts({{3590, 4300}}), kFlight);
  ASSERT_EQ(late.violations.size(), 1U) << "the first tick after the outage";
  const RestartFlight early = flyRestarts(mission, cuts({{1000, 1710}}), kFlight);
  EXPECT_TRUE(early.violations.empty());
}

TEST(WatchedOverCuts, AMissionThatIsOverViolatesNothingMore) {
  const RestartFlight flight = flyRestarts(
      inTurn("resume within 1 min\nrequire exit within 61 min\nrequire visit a within 1 h\n"),
      cuts({{500, 4500}}), kFlight);
  EXPECT_TRUE(flight.violations.empty());
}

/// The thermocline is at 14 m.
TEST(WatchedOverCuts, AssumptionsAreWatchedToo) {
  const RestartFlight flight =
      flyRestarts(inTurn("assume temp >= 20 degC\n"), cuts({{60, 100}}), kFlight);
  ASSERT_EQ(flight.violations.size(), 1U);
  EXPECT_GT(flight.violations[0].mission_time, 100);
  EXPECT_THAT(flight.violations[0].after, HasSubstr("outage"));
}

/// All checkpoints are lost. Each mission has its own count.
TEST(WatchedOverCuts, AMissionThatBeginsAgainIsWatchedFromItsStart) {
  simulator::Faults faults = cuts({{1520, 1560}});
  faults.card.push_back({1530, simulator::CardFault::Kind::Cut, 0});
  const RestartFlight six =
      flyRestarts(inTurn("require visit b at most 6 times\n"), faults, 2 * kFlight);
  EXPECT_TRUE(six.violations.empty());
  EXPECT_GT(six.visits("b"), 6U);
  const RestartFlight three =
      flyRestarts(inTurn("require visit b at most 3 times\n"), faults, 2 * kFlight);
  ASSERT_EQ(three.violations.size(), 1U);
  EXPECT_THAT(three.violations[0].after, HasSubstr("the mission had begun again"));
}

/// A clock of the SBC that jumps does not move the true depth.
TEST(WatchedOverCuts, TheTrueDepthIsThatOfTheTick) {
  simulator::Faults faults = cuts({{1500, 1540}});
  faults.clock.push_back({300, 95});
  const RestartFlight flight =
      flyRestarts(inTurn("require always depth <= 11 m || statetime < 2 min || missiontime > 9 min "
                         "|| missiontime < 3 min\n"),
                  faults, kFlight);
  const RestartFlight same =
      flyRestarts(inTurn("require always depth <= 11 m || statetime < 2 min || missiontime > 9 min "
                         "|| missiontime < 3 min\n"),
                  {}, kFlight);
  EXPECT_EQ(flight.violations.size(), same.violations.size());
}

}  // namespace
}  // namespace glider::tests
