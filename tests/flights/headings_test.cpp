// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Headings off New Jersey, where the needle points 12 degrees west of north: the vehicle goes where
// the mission says.

#include "tests/flights/flight.h"

#include <gtest/gtest.h>

#include <cmath>
#include <gmock/gmock.h>
#include <numbers>

namespace glider::tests {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr double kDegPerRad = 180 / std::numbers::pi;

/// The default scenario in still water, with `more` behind it.
std::filesystem::path stillWater(const TemporaryFolder& folder, const std::string& more) {
  std::string text = slurp(project("scenarios/default.toml"));
  for (const char* current : {"current_east_mps = 0.02\n", "current_north_mps = -0.03\n"}) {
    const size_t at = text.find(current);
    EXPECT_NE(at, std::string::npos);
    text.erase(at, std::string(current).size());
  }
  (void)folder.write("skeleton.mi", slurp(project("scenarios/skeleton.mi")));
  return folder.write("still.toml", text + more);
}

std::string east(const std::string& line, const std::string& route) {
  return "mission eastward\n" + line + "\nstate out\nbegin\n  flightroute " + route +
         "\n  flightprofile yo(5 m, 20 m, 26 deg, 26 deg)\n  sensors missiontime, heading\n"
         "  events\n    case missiontime >= 2 h exit\nend\n";
}

/// Two hours of `mission` in still water.
Flight flyEast(const std::string& line, const std::string& route, const std::string& more = "") {
  const TemporaryFolder folder;
  return fly(folder.write("eastward.mission", east(line, route)).string() + " --scenario " +
             stillWater(folder, more).string());
}

/// Of the way that the vehicle truly went under the mission: degrees clockwise from north.
double trackOf(const Flight& flight) {
  const auto x = flight.column("true_x"), y = flight.column("true_y");
  const auto active = flight.column("hook_active");
  size_t first = 0, last = 0;
  for (size_t i = 0; i < x.size(); ++i) {
    if (active[i] == 1) {
      first = first == 0 ? i : first;
      last = i;
    }
  }
  EXPECT_GT(std::hypot(x[last] - x[first], y[last] - y[first]), 1500);
  return std::atan2(x[last] - x[first], y[last] - y[first]) * kDegPerRad;
}

/// Distance from the true position to the dead-reckoned one, metres, at the end of the mission.
double reckoningError(const Flight& flight) {
  const auto x = flight.column("true_x"), y = flight.column("true_y");
  const auto mx = flight.column("m_x_lmc"), my = flight.column("m_y_lmc");
  const auto active = flight.column("hook_active");
  double error = 0;
  for (size_t i = 0; i < x.size(); ++i) {
    error = active[i] == 1 ? std::abs(std::atan2(mx[i], my[i]) - std::atan2(x[i], y[i])) : error;
  }
  return error * kDegPerRad;
}

constexpr const char* kNoVariation =
    "\n[[faults.sensor]]\nsensor = \"m_gps_mag_var\"\nfrom_s = 0\nmissing = true\n";

TEST(Headings, EastIsTrueEastByTheVehiclesVariation) {
  const Flight flight = flyEast("", "heading(90 deg)");
  ASSERT_EQ(flight.outcome.status, 0) << flight.outcome.err;
  EXPECT_NEAR(trackOf(flight), 90, 2);
  EXPECT_LT(reckoningError(flight), 2);
  // The vehicle's own sensors are magnetic: 12 degrees more.
  const auto heading = flight.column("c_heading");
  EXPECT_NEAR(heading[heading.size() / 2] * kDegPerRad, 102.35, 0.2);
}

TEST(Headings, AVehicleThatDoesNotReportItsVariationFliesByTheLine) {
  const Flight flight = flyEast("declination -12.3 deg", "heading(90 deg)", kNoVariation);
  ASSERT_EQ(flight.outcome.status, 0) << flight.outcome.err;
  EXPECT_NEAR(trackOf(flight), 90, 2);
}

TEST(Headings, TheVehiclesVariationGoesBeforeTheLine) {
  const Flight flight = flyEast("declination 40 deg", "heading(90 deg)");
  ASSERT_EQ(flight.outcome.status, 0) << flight.outcome.err;
  EXPECT_NEAR(trackOf(flight), 90, 2);
}

TEST(Headings, WithoutEitherTheFlightIsOffByTheDeclinationAndReportsThat) {
  const Flight flight = flyEast("", "heading(90 deg)", kNoVariation);
  EXPECT_NEAR(trackOf(flight), 77.65, 2);
  bool told = false;
  for (const Event& event : flight.events) {
    told = told || (event.what + event.why).find("declination unknown") != std::string::npos;
  }
  EXPECT_TRUE(told);
  EXPECT_THAT(flight.outcome.out, HasSubstr("the magnetic declination was unknown"));
  EXPECT_THAT(flyEast("", "heading(90 deg)").outcome.out, Not(HasSubstr("declination")));
}

TEST(Headings, MagneticEastIsEastOnTheCompassWhateverIsKnown) {
  for (const char* line : {"", "declination -12.3 deg", "declination 40 deg"}) {
    for (const char* route : {"heading(90 deg magnetic)", "heading(magnetic(100 deg - 10 deg))"}) {
      for (const char* more : {"", kNoVariation}) {
        const Flight flight = flyEast(line, route, more);
        ASSERT_EQ(flight.outcome.status, 0) << flight.outcome.err;
        const auto heading = flight.column("c_heading");
        EXPECT_NEAR(heading[heading.size() / 2] * kDegPerRad, 90, 0.2) << line << route << more;
      }
    }
  }
}

TEST(Headings, AWaypointIsReachedThroughTheSameWater) {
  // 2.2 km due east of the start.
  const Flight flight = flyEast("", "nav(39.175 N, 73.81 W)");
  ASSERT_EQ(flight.outcome.status, 0) << flight.outcome.err;
  const auto latitude = flight.column("true_lat"), longitude = flight.column("true_lon");
  double nearest = 1e9;
  for (size_t i = 0; i < latitude.size(); ++i) {
    nearest = std::min(nearest,
                       std::hypot((latitude[i] - 39.175) * 111200, (longitude[i] + 73.81) * 86300));
  }
  EXPECT_LT(nearest, 150);
}

TEST(Headings, TheVehicleSteersStraightToAWaypoint) {
  const Flight flight = flyEast("", "nav(39.175 N, 73.70 W)");  // 11.6 km east
  ASSERT_EQ(flight.outcome.status, 0) << flight.outcome.err;
  EXPECT_NEAR(trackOf(flight), 90, 2);
}

TEST(Headings, ABearingIsAHeading) {
  const Flight flight = flyEast("", "heading(bearing(39.175 N 73.70 W))");
  ASSERT_EQ(flight.outcome.status, 0) << flight.outcome.err;
  EXPECT_NEAR(trackOf(flight), 90, 2);
}

}  // namespace
}  // namespace glider::tests
