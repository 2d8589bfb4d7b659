// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Missions in the language, flown in the shipped worlds: the disturbances of the paper's two
// deployments, and what their sensors let a mission react to.

#include "tests/flights/flight.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace glider::tests {
namespace {

std::string world(const std::string& name) {
  return " --scenario " + project("scenarios/" + name + ".toml");
}

/// Flies a yo to the east until `guard` and then releases control; 3000 s at most.
Flight flyUntil(const std::string& guard, const std::string& name, int bottom_m = 25) {
  const TemporaryFolder folder;
  const auto mission = folder.write("until.mission",
                                    "mission until\n"
                                    "state a\nbegin\n  flightroute heading(90 deg)\n"
                                    "  flightprofile yo(5 m, " +
                                        std::to_string(bottom_m) +
                                        " m, 26 deg, 26 deg)\n"
                                        "  sensors missiontime, depth, temp, chlorophyll, oxygen, "
                                        "altitude, battery\n"
                                        "  events\n    case " +
                                        guard +
                                        " exit\n"
                                        "    case missiontime >= 3000 s exit\nend\n");
  Flight flight = fly(mission.string() + world(name));
  // Each world lacks some of the sensors, which is a warning.
  EXPECT_LE(flight.outcome.status, 1) << flight.outcome.err;
  return flight;
}

/// The one transition of `flight`; its guard must be the one that was asked for.
Event endOf(const Flight& flight, const std::string& guard) {
  const auto transitions = flight.transitions();
  EXPECT_EQ(transitions.size(), 1U);
  const Event end = transitions.empty() ? Event{} : transitions.back();
  EXPECT_NE(end.why.find(guard), std::string::npos) << end.why;
  return end;
}

TEST(Worlds, BloomIsFound) {
  const Flight flight = flyUntil("chlorophyll > 4", "bloom", 20);
  const Event end = endOf(flight, "chlorophyll > 4");
  EXPECT_NEAR(flight.valueAt("true_x", end.time_s), 425, 30);
}

TEST(Worlds, OxygenFallsBelowTheThermocline) {
  const Flight flight = flyUntil("oxygen < 200", "bloom", 20);
  EXPECT_GT(flight.valueAt("true_depth", endOf(flight, "oxygen < 200").time_s), 14);
}

TEST(Worlds, SeamountIsDetected) {
  const Flight flight = flyUntil("altitude < 12 m", "shelf_slope", 20);
  const Event end = endOf(flight, "altitude < 12");
  EXPECT_NEAR(flight.valueAt("true_x", end.time_s), 527, 40);
}

TEST(Worlds, BatteryRunsLow) {
  const Flight flight = flyUntil("battery < 11 V", "low_battery");
  // The first stroke of the pump that pulls the voltage so low; without load it is 11.5 V then.
  EXPECT_NEAR(endOf(flight, "battery < 11").time_s, 2068, 60);
}

TEST(Worlds, FrontIsCrossed) {
  const Flight flight = flyUntil("depth < 8 m && temp < 18 degC", "front");
  // The middle of the front is at 700 m; the vehicle is above 8 m once in each yo, about 90 m
  // apart.
  const double crossed = flight.valueAt("true_x", endOf(flight, "temp < 18").time_s);
  EXPECT_GT(crossed, 695);
  EXPECT_LT(crossed, 820);
}

}  // namespace
}  // namespace glider::tests
