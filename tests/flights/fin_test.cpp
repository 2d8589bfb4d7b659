// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Missions that hold the fin: to which side and how fast the vehicle turns, and what becomes of it
// through calls, power cuts of the SBC, and after the end of control.

#include "tests/flights/flight.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace glider::tests {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

/// Angle of the fin in degrees, the scenario, and the turn rate in deg/s that a vehicle of
/// 0.28 to 0.34 m/s has by the yaw of the platform file.
struct Held {
  const char* scenario;
  double fin_deg, least, most;
};

std::string mission(const std::string& events, const std::string& more = "") {
  return "mission held\nresume within 20 min\nparam side: angle = 0 deg in -0.45 rad .. 0.45 rad\n"
         "state down\nbegin\n  flightroute   fixed_fin(side)\n"
         "  flightprofile yo(5 m, 25 m, 26 deg, 26 deg)\n"
         "  sensors       missiontime, statetime, depth\n  events\n" +
         events + "end\n" + more;
}

Flight flyHeld(const std::string& text, double fin_deg, const std::string& scenario,
               const std::string& faults = "", const std::string& board = "") {
  const TemporaryFolder folder;
  std::filesystem::copy(project("scenarios"), folder.path());
  const auto world =
      folder.write("world.toml", slurp(project("scenarios/" + scenario + ".toml")) + faults);
  return fly(folder.write("held.mission", text).string() + " --scenario " + world.string() +
             " --set 'side=" + std::to_string(fin_deg) + " deg'" + board);
}

/// How far it turns between two times of the flight, deg, positive to starboard. Rows are 4 s
/// apart, in which it turns by less than half a turn.
double turned(const Flight& flight, double from_s, double to_s) {
  const auto time = flight.column("time");
  const auto heading = flight.column("m_heading");
  double sum = 0;
  for (size_t i = 1; i < time.size(); ++i) {
    if (time[i - 1] >= from_s && time[i] <= to_s && std::isfinite(heading[i] - heading[i - 1])) {
      sum += std::remainder(heading[i] - heading[i - 1], 2 * std::numbers::pi);
    }
  }
  return sum / kDegree;
}

double rate(const Flight& flight, double from_s, double to_s) {
  return turned(flight, from_s, to_s) / (to_s - from_s);
}

class HeldFin : public testing::TestWithParam<Held> {};

TEST_P(HeldFin, TurnsToItsSide) {
  const Held& held = GetParam();
  const Flight flight =
      flyHeld(mission("    case missiontime > 30 min exit\n"), held.fin_deg, held.scenario);
  const auto transitions = flight.transitions();
  ASSERT_EQ(transitions.size(), 1U) << flight.outcome.err;
  EXPECT_EQ(transitions.back().what, "down → end (exit)");
  const double mean = rate(flight, 200, 1700);
  EXPECT_GT(mean, held.least);
  EXPECT_LT(mean, held.most);
  EXPECT_GT(std::ranges::max(flight.column("true_depth")), 20) << "a yo goes on";
}

INSTANTIATE_TEST_SUITE_P(
    , HeldFin,
    testing::Values(Held{"default", 10, 0.6, 0.85}, Held{"default", -10, -0.85, -0.6},
                    Held{"bloom", 25.78, 1.5, 2}, Held{"front", -25.78, -2, -1.5},
                    Held{"shelf_slope", 5, 0.3, 0.42}, Held{"first_deployment", -5, -0.42, -0.3},
                    Held{"low_battery", 0, -0.02, 0.02}));

TEST(HeldFins, AreHeldAgainAfterACall) {
  const Flight flight =
      flyHeld(mission("    case missiontime > 30 min exit\n    case statetime > 10 min && "
                      "statetime < 11 min call straight\n",
                      "state straight\nbegin\n  flightroute heading(90 deg)\n  flightprofile yo(5 "
                      "m, 25 m, 26 deg, 26 deg)\n"
                      "  sensors statetime\n  events\n    case statetime > 5 min return\nend\n"),
              -12, "default");
  ASSERT_EQ(flight.outcome.status, 0) << flight.outcome.err;
  ASSERT_EQ(flight.transitions().size(), 3U);
  EXPECT_LT(turned(flight, 200, 600), -250);
  EXPECT_LT(std::fabs(turned(flight, 740, 900)), 30) << "a heading is kept";
  EXPECT_LT(turned(flight, 960, 1360), -250) << "to port again";
}

class CutFin : public testing::TestWithParam<const char*> {};

/// 30 s are noticed neither by hookbeh nor by the fin; after 200 s the mission goes on.
TEST_P(CutFin, IsHeldAgainAfterAPowerCut) {
  const auto cut = [](int to_s) {
    return "\n[[faults.power]]\nfrom_s = 800\nto_s = " + std::to_string(to_s) + "\n";
  };
  const std::string text = mission("    case missiontime > 30 min exit\n");
  const Flight brief = flyHeld(text, 10, "default", cut(812), GetParam());
  ASSERT_EQ(brief.outcome.status, 0) << brief.outcome.err;
  EXPECT_GT(rate(brief, 800, 900), 0.5) << "the last command stays in force";
  const Flight longer = flyHeld(text, 10, "default", cut(1000), GetParam());
  ASSERT_EQ(longer.outcome.status, 0) << longer.outcome.err;
  EXPECT_LT(std::fabs(rate(longer, 880, 990)), 0.2) << "the vehicle's own mission holds no fin";
  EXPECT_GT(rate(longer, 1100, 1700), 0.5);
}

INSTANTIATE_TEST_SUITE_P(, CutFin, testing::Values("", " --board host", " --board ts7800"));

TEST(HeldFins, AreCentredAfterTheEndOfControl) {
  const Flight flight = flyHeld(mission("    case missiontime > 10 min exit\n"), 25, "default");
  ASSERT_EQ(flight.outcome.status, 0) << flight.outcome.err;
  const double end = flight.column("time").back();
  EXPECT_GT(rate(flight, 200, 600), 1.2);
  EXPECT_LT(std::fabs(rate(flight, end - 20, end)), 0.5);
}

}  // namespace
}  // namespace glider::tests
