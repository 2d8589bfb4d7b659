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
constexpr double kLag_s = 15 + 4 * kCycle_s;

std::string missionText(const std::string& nap) {
  return "mission sleeper\n" + nap + R"(
state out
begin
  flightroute   heading(90 deg)
  flightprofile yo(5 m, 25 m)
  sensors       missiontime, depth, battery every 60 s
  events
    case battery < 9 V exit
    case became(depth > 24 m) && statetime > 20 min goto slow
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
  flightprofile yo(5 m, 25 m)
  sensors       missiontime, depth, temp
  events
    case missiontime > 75 min exit
end
)";
}

struct Pair {
  Flight awake, asleep;
};

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

/// The same transitions, in the same order. The vehicle turns later by the time to wake.
void expectAlike(const Pair& flights) {
  ASSERT_EQ(flights.awake.outcome.status, 0) << flights.awake.outcome.err;
  ASSERT_EQ(flights.asleep.outcome.status, 0) << flights.asleep.outcome.err;
  const auto awake = flights.awake.transitions();
  const auto asleep = flights.asleep.transitions();
  ASSERT_EQ(awake.size(), asleep.size());
  EXPECT_GE(awake.size(), 3U);
  for (size_t i = 0; i < awake.size(); ++i) {
    EXPECT_EQ(awake[i].what, asleep[i].what);
  }
}

TEST(Naps, AreFlownAsWithout) {
  const Pair flights = flyBoth("");
  expectAlike(flights);
  EXPECT_GT(sleepsOf(flights.asleep), 10U);
  EXPECT_EQ(sleepsOf(flights.awake), 0U);
}

}  // namespace
}  // namespace glider::tests
