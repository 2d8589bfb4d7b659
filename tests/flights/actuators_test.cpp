// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Missions that command the pump and the pitch battery: what the vehicle does, in process and as
// the programs of boards, through a power cut, and at hookbeh's limits.

#include "tests/flights/flight.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace glider::tests {
namespace {

std::string mission(const std::string& volume, const std::string& position,
                    const std::string& events) {
  return "mission trimmed\nresume within 20 min\n"
         "state trim\nbegin\n  flightroute   heading(90 deg)\n"
         "  flightprofile fixed_trim(" +
         volume + ", " + position +
         ")\n  sensors       missiontime, statetime, depth, m_battpos, x_hook_guard\n  events\n" +
         events + "end\nstate up\nbegin\n  flightroute   noheading\n  flightprofile surfaced\n" +
         "  sensors       depth\n  events\n    case depth < 1 m exit\nend\n";
}

Flight flyTrimmed(const std::string& text, const std::string& faults = "",
                  const std::string& board = "") {
  const TemporaryFolder folder;
  std::filesystem::copy(project("scenarios"), folder.path());
  const auto world = folder.write("world.toml", slurp(project("scenarios/default.toml")) + faults);
  return fly(folder.write("trimmed.mission", text).string() + " --scenario " + world.string() +
             board);
}

/// Of a column, between two times of the flight.
std::vector<double> during(const Flight& flight, const char* column, double from_s, double to_s) {
  const auto time = flight.column("time");
  const auto values = flight.column(column);
  std::vector<double> found;
  for (size_t i = 0; i < time.size(); ++i) {
    if (time[i] >= from_s && time[i] <= to_s) {
      found.push_back(values[i]);
    }
  }
  return found;
}

TEST(Actuators, MoveToWhereTheyAreCommandedAndStay) {
  const Flight flight = flyTrimmed(
      mission("-60 cc", "5.08 mm", "    case depth > 20 m || statetime > 10 min goto up\n"));
  ASSERT_EQ(flight.outcome.status, 0) << flight.outcome.err;
  ASSERT_EQ(flight.transitions().size(), 2U);
  const double left = flight.transitions().front().time_s;
  for (const double cc : during(flight, "m_ballast_pumped", 40, left)) {
    EXPECT_NEAR(cc, -60, 1);
  }
  for (const double in : during(flight, "m_battpos", 40, left)) {
    EXPECT_NEAR(in, 0.2, 0.02);
  }
  EXPECT_GT(std::ranges::max(flight.column("true_depth")), 4) << "it sinks gently";
  EXPECT_LT(flight.column("true_depth").back(), 1) << "and comes up";
}

TEST(Actuators, AreTheSameOnEveryBoard) {
  const std::string text = mission(
      "-120 cc", "0.3 inch",
      "    case depth > 15 m && statetime < 5 min do pump(80 cc) battery(-0.1 inch) end stay\n"
      "    case statetime > 12 min goto up\n");
  const Flight here = flyTrimmed(text);
  ASSERT_EQ(here.outcome.status, 0) << here.outcome.err;
  for (const char* board : {" --board host", " --board ts7800", " --board ts5500"}) {
    const Flight there = flyTrimmed(text, "", board);
    ASSERT_EQ(there.outcome.status, 0) << there.outcome.err;
    for (const char* column : {"true_depth", "m_ballast_pumped", "m_battpos", "m_pitch"}) {
      EXPECT_EQ(here.column(column), there.column(column)) << board << column;
    }
  }
}

/// Of skeleton.mi, m.
constexpr double kMaxDepth = 60;

class SinksForGood : public testing::TestWithParam<const char*> {};

TEST_P(SinksForGood, AndHookbehBringsItUp) {
  const Flight flight =
      flyTrimmed(mission("-233 cc", GetParam(), "    case statetime > 50 min goto up\n"));
  ASSERT_EQ(flight.transitions().size(), 2U) << flight.outcome.err;
  const auto depth = flight.column("true_depth");
  EXPECT_LT(std::ranges::max(depth), kMaxDepth + 5) << "the guard turns within the overshoot";
  EXPECT_GT(std::ranges::max(depth), kMaxDepth - 1) << "but no sooner";
  const auto guard = flight.column("x_hook_guard");
  EXPECT_GT(std::ranges::count(guard, 1.0), 10) << "too deep";
  const auto after = during(flight, "true_depth", 1500, 2900);
  EXPECT_LT(std::ranges::min(after), kMaxDepth / 2 + 2) << "it climbs half of the way";
  EXPECT_LT(std::ranges::max(after), kMaxDepth + 5) << "each time";
  for (size_t i = 1; i < depth.size(); ++i) {
    EXPECT_LE(std::fabs(depth[i] - depth[i - 1]), 0.4 * 4) << "the vertical rate of proofs";
  }
}

INSTANTIATE_TEST_SUITE_P(, SinksForGood,
                         testing::Values("0 mm", "0.4 inch", "0.6 inch", "-0.2 inch"));

class CutTrim : public testing::TestWithParam<const char*> {};

TEST_P(CutTrim, IsCommandedAgainAfterAPowerCut) {
  const std::string text = mission("-40 cc", "0.1 inch", "    case statetime > 25 min goto up\n");
  const Flight flight =
      flyTrimmed(text, "\n[[faults.power]]\nfrom_s = 400\nto_s = 600\n", GetParam());
  ASSERT_EQ(flight.outcome.status, 0) << flight.outcome.err;
  const auto before = during(flight, "m_ballast_pumped", 250, 300);
  EXPECT_NEAR(before.back(), -40, 1);
  EXPECT_GT(during(flight, "m_ballast_pumped", 500, 590).back(), 100) << "its own mission climbs";
  EXPECT_NEAR(during(flight, "m_ballast_pumped", 700, 800).back(), -40, 1);
  EXPECT_NEAR(during(flight, "m_battpos", 700, 800).back(), 0.1, 0.02);
}

INSTANTIATE_TEST_SUITE_P(, CutTrim, testing::Values("", " --board ts7800"));

}  // namespace
}  // namespace glider::tests
