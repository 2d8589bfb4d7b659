// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// An SBC that sleeps between ticks flies as one that does not, except for the time to wake.

#include "tests/flights/flight.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace glider::tests {
namespace {

constexpr double kCycle_s = 4;

std::string missionText(const std::string& nap) {
  return "mission sleeper\n" + nap + R"(
state out
begin
  flightroute   heading(90 deg)
  flightprofile yo(5 m, 50 m)
  sensors       missiontime, depth, battery every 60 s
  events
    case battery < 9 V exit
    case became(depth > 48 m) && statetime > 20 min goto slow
end

state slow
begin
  flightroute   noheading
  flightprofile hover_at(12 m)
  sensors       missiontime, depth, temp
  events
    case statetime >= 13 min goto back
end

state back
begin
  flightroute   heading(270 deg)
  flightprofile yo(5 m, 50 m)
  sensors       missiontime, depth, temp
  events
    case missiontime > 75 min exit
end
)";
}

struct Pair {
  Flight awake, asleep;
};

/// Of the SBC, Wh: by the line "of it" of the summary.
double shareOfSbc(const Flight& flight) {
  const size_t at = flight.outcome.out.find("SBC ", flight.outcome.out.find("of it"));
  return at == std::string::npos ? 0 : std::stod(flight.outcome.out.substr(at + 4));
}

Pair flyBoth(const std::string& more) {
  const TemporaryFolder folder;
  const std::string awake = folder.write("awake.mission", missionText(""));
  const std::string asleep = folder.write("asleep.mission", missionText("nap at most 4 min"));
  return {fly(awake + more), fly(asleep + more)};
}

size_t sleepsOf(const Flight& flight) {
  return static_cast<size_t>(std::ranges::count_if(
      flight.events, [&](const Event& e) { return e.what.starts_with("the SBC sleeps"); }));
}

/// The same transitions at the same times, to what the line between the vehicle's computers adds:
/// the SBC is awake before a depth that the vehicle goes to and before a time.
void expectAlike(const Pair& flights) {
  ASSERT_EQ(flights.awake.outcome.status, 0) << flights.awake.outcome.err;
  ASSERT_EQ(flights.asleep.outcome.status, 0) << flights.asleep.outcome.err;
  const auto awake = flights.awake.transitions();
  const auto asleep = flights.asleep.transitions();
  ASSERT_EQ(awake.size(), asleep.size());
  EXPECT_GE(awake.size(), 3U);
  for (size_t i = 0; i < awake.size(); ++i) {
    EXPECT_EQ(awake[i].what, asleep[i].what);
    EXPECT_NEAR(awake[i].time_s, asleep[i].time_s, 2 * kCycle_s) << awake[i].what;
  }
}

TEST(Naps, AreFlownAsWithout) {
  const Pair flights = flyBoth("");
  expectAlike(flights);
  EXPECT_GT(sleepsOf(flights.asleep), 10U);
  EXPECT_EQ(sleepsOf(flights.awake), 0U);
}

TEST(Naps, SaveWhatABoardThatSleepsDoesNotDraw) {
  const TemporaryFolder folder;
  const std::string scenario =
      folder.write("board.toml", slurp(project("scenarios/default.toml")) +
                                     "\n[vehicle.battery]\nsbc_W = 3.42\nsbc_asleep_W = 0.1\n");
  const Pair flights = flyBoth(" --scenario " + scenario);
  expectAlike(flights);
  EXPECT_GT(shareOfSbc(flights.awake), 40);
  EXPECT_LT(shareOfSbc(flights.asleep), shareOfSbc(flights.awake) - 20);
}

/// The vehicle's line loses the SBC's own heartbeats between two naps again and again.
TEST(Naps, AnSbcThatWakesInTimeKeepsControl) {
  const TemporaryFolder folder;
  const std::string mission = folder.write("hover.mission", R"(mission hover
nap at most 4 min
state hold
begin
  flightroute   noheading
  flightprofile hover_at(30 m)
  sensors       missiontime, depth
  events
    case missiontime > 10 h exit
end
)");
  for (const char* seed : {"1", "2", "3"}) {
    const Flight flight = fly(mission + " --duration 10h --seed " + seed);
    ASSERT_EQ(flight.outcome.status, 0) << flight.outcome.err;
    EXPECT_GT(sleepsOf(flight), 100U);
    EXPECT_TRUE(std::ranges::none_of(flight.events, [](const Event& e) {
      return e.what.find("revoked") != std::string::npos;
    })) << seed;
  }
}

/// The SBC's own clock says nothing of a sleep: the vehicle keeps its frames with their times.
TEST(Naps, AClockThatJumpsInANapChangesNothing) {
  const TemporaryFolder folder;
  const std::string mission = folder.write("asleep.mission", missionText("nap at most 4 min"));
  const std::string scenario =
      folder.write("jumps.toml", slurp(project("scenarios/default.toml")) +
                                     "\n[[faults.clock]]\nat_s = 1900\nby_s = 995076\n");
  const Flight whole = fly(mission), jumps = fly(mission + " --scenario " + scenario);
  ASSERT_EQ(jumps.outcome.status, 0) << jumps.outcome.err;
  EXPECT_TRUE(std::ranges::any_of(jumps.events, [](const Event& e) {
    return e.time_s > 1700 && e.time_s < 1720 && e.what.starts_with("the SBC sleeps");
  }));
  EXPECT_TRUE(std::ranges::none_of(
      jumps.events, [](const Event& e) { return e.what.find("revoked") != std::string::npos; }));
  const auto expected = whole.transitions(), found = jumps.transitions();
  ASSERT_EQ(found.size(), expected.size());
  for (size_t i = 0; i < found.size(); ++i) {
    EXPECT_EQ(found[i].what, expected[i].what);
    EXPECT_NEAR(found[i].time_s, expected[i].time_s, 2 * kCycle_s);
  }
}

}  // namespace
}  // namespace glider::tests
