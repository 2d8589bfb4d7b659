// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Routes along paths: what they cover, and that they come to an end.

#include "tests/flights/flight.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace glider::tests {
namespace {

/// Metres east and north on a plane that is true enough for a few kilometres.
struct Point {
  double x = 0, y = 0;
};

constexpr double kMetresPerDegree = 6371008.8 * std::numbers::pi / 180;

Point pointOf(double latitude, double longitude) {
  constexpr double kLatitude = 39.178;
  return {(longitude + 73.83) * kMetresPerDegree * std::cos(kLatitude * std::numbers::pi / 180),
          (latitude - kLatitude) * kMetresPerDegree};
}

double distance(const Point& a, const Point& b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

/// The corners of missions/gallery/hull_sweep.mission, which are those of a convex area.
const std::vector<Point> kArea = {pointOf(39.1765, -73.8340), pointOf(39.1800, -73.8330),
                                  pointOf(39.1815, -73.8270), pointOf(39.1790, -73.8240),
                                  pointOf(39.1755, -73.8260)};

/// A fine grid over the area, triangle by triangle.
std::vector<Point> gridOfArea() {
  constexpr int kFine = 24;
  std::vector<Point> grid;
  for (size_t corner = 1; corner + 1 < kArea.size(); ++corner) {
    for (int i = 0; i <= kFine; ++i) {
      for (int j = 0; i + j <= kFine; ++j) {
        const double u = static_cast<double>(i) / kFine;
        const double v = static_cast<double>(j) / kFine;
        grid.push_back({(1 - u - v) * kArea[0].x + u * kArea[corner].x + v * kArea[corner + 1].x,
                        (1 - u - v) * kArea[0].y + u * kArea[corner].y + v * kArea[corner + 1].y});
      }
    }
  }
  return grid;
}

std::vector<Point> trackOf(const Flight& flight, const std::string& whose) {
  const auto north = flight.column(whose + "_lat");
  const auto east = flight.column(whose + "_lon");
  const auto active = flight.column("hook_active");
  std::vector<Point> track;
  for (size_t i = 0; i < north.size(); ++i) {
    if (active[i] == 1) {
      track.push_back(pointOf(north[i], east[i]));
    }
  }
  return track;
}

/// Of the area, what share lies within `reach` m of the track.
double covered(const std::vector<Point>& track, double reach) {
  const auto grid = gridOfArea();
  const auto near = [&](const Point& p) {
    return std::ranges::any_of(track, [&](const Point& q) { return distance(p, q) <= reach; });
  };
  return static_cast<double>(std::ranges::count_if(grid, near)) / static_cast<double>(grid.size());
}

TEST(Sweep, CoversTheHullAndIsDone) {
  const Flight flight = fly(project("missions/gallery/hull_sweep.mission") + " --scenario " +
                            project("scenarios/default.toml"));
  ASSERT_EQ(flight.outcome.status, 0) << flight.outcome.err;
  const auto transitions = flight.transitions();
  ASSERT_FALSE(transitions.empty());
  EXPECT_EQ(transitions.back().what, "map → end (exit)");
  EXPECT_NE(transitions.back().why.find("routedone"), std::string::npos) << transitions.back().why;
  // Lanes are at most 250 m apart. The vehicle follows them on its reckoning, and is carried off
  // it by the current between two fixes.
  const auto reckoned = trackOf(flight, "m");
  EXPECT_GE(covered(reckoned, 125), 0.98);
  EXPECT_EQ(covered(reckoned, 150), 1);
  const auto true_track = trackOf(flight, "true");
  EXPECT_GE(covered(true_track, 125), 0.9);
  EXPECT_EQ(covered(true_track, 250), 1);
}

std::string withLine(std::string text, const std::string& from, const std::string& to) {
  const size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

/// Flies `along` three way-points with a capture radius of `capture` in a current to the north,
/// m/s.
Flight flyAlong(const std::string& capture, const std::string& current) {
  const TemporaryFolder folder;
  (void)folder.write("skeleton.mi", slurp(project("scenarios/skeleton.mi")));
  const auto scenario = folder.write(
      "current.toml", withLine(slurp(project("scenarios/default.toml")),
                               "current_north_mps = -0.03", "current_north_mps = " + current));
  const auto mission = folder.write(
      "along.mission",
      "mission along_path\n"
      "const track : path = [39.1765 N 73.8330 W, 39.1765 N 73.8300 W, 39.1790 N 73.8300 W]\n"
      "state sail\nbegin\n"
      "  flightroute   along(track, " +
          capture +
          ")\n"
          "  flightprofile yo(4 m, 20 m, 26 deg, 26 deg)\n"
          "  sensors       missiontime, lat, lon\n"
          "  events\n"
          "    case routedone exit\n"
          "    case missiontime > 5 h exit\n"
          "    case resumetime > 10 min call fix\n"
          "end\n"
          "state fix\nbegin\n"
          "  flightprofile surfaced\n"
          "  sensors       depth, statetime\n"
          "  events\n"
          "    case held(depth < 1 m, 60 s) || statetime > 10 min return\n"
          "end\n");
  return fly(mission.string() + " --scenario " + scenario.string());
}

class Along : public testing::TestWithParam<std::pair<const char*, const char*>> {};

/// A capture radius that the vehicle passes in less than a tick, and currents that carry it past.
TEST_P(Along, IsDoneWhateverTheDrift) {
  const Flight flight = flyAlong(GetParam().first, GetParam().second);
  ASSERT_EQ(flight.outcome.status, 0) << flight.outcome.err;
  const auto transitions = flight.transitions();
  ASSERT_FALSE(transitions.empty());
  EXPECT_NE(transitions.back().why.find("routedone"), std::string::npos) << transitions.back().why;
  EXPECT_LT(transitions.back().mission_time_s, 3 * 3600);
  // All three were sailed for: of each leg the vehicle has been near to the end, or abeam of it.
  const auto track = trackOf(flight, "m");
  for (const Point& waypoint :
       {pointOf(39.1765, -73.8330), pointOf(39.1765, -73.8300), pointOf(39.1790, -73.8300)}) {
    double least = 1e9;
    for (const Point& p : track) {
      least = std::min(least, distance(p, waypoint));
    }
    EXPECT_LT(least, 200);
  }
}

INSTANTIATE_TEST_SUITE_P(Currents, Along,
                         testing::Values(std::pair("100 m", "-0.03"), std::pair("1 m", "-0.03"),
                                         std::pair("1 m", "0.15"), std::pair("1 m", "-0.15"),
                                         std::pair("0.01 m", "0")));

}  // namespace
}  // namespace glider::tests
