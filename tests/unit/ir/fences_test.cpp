// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Areas to keep in and out of: the map's distances against the ellipsoid's, and what is said to be
// kept against vehicles that a current sets about.

#include "ir/prove/fences.h"

#include "ir/eval/arithmetic.h"
#include "ir/prove/area_map.h"
#include "ir/prove/random_flight.h"
#include "ir/prove/steering.h"
#include "tests/random_missions/random.h"
#include "tests/unit/ir/missions.h"
#include "tests/unit/ir/slocum.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace glider::ir::prove {
namespace {

using Places = std::vector<Position>;

double unit(random_missions::Random& random) {
  return static_cast<double>(random.below(1U << 20)) / (1U << 20);
}

Position near(const Position& middle, double degrees, random_missions::Random& random) {
  return {middle.latitude + degrees * (2 * unit(random) - 1),
          middle.longitude + degrees * (2 * unit(random) - 1)};
}

Position between(const Position& a, const Position& b, double share) {
  return {a.latitude + share * (b.latitude - a.latitude),
          a.longitude + share * (b.longitude - a.longitude)};
}

/// The least distance, m, between points of the edge and points of the legs between all waypoints.
double sampledDistance(const Places& corners, const Places& waypoints) {
  constexpr int kSamples = 60;
  double least = std::numeric_limits<double>::infinity();
  for (size_t i = 0; i < corners.size(); ++i) {
    for (const Position& from : waypoints) {
      for (const Position& to : waypoints) {
        for (int k = 0; k <= kSamples * kSamples; ++k) {
          const Position edge = between(corners[i], corners[(i + 1) % corners.size()],
                                        static_cast<double>(k % kSamples) / (kSamples - 1));
          const Position leg = between(from, to, static_cast<double>(k / kSamples) / kSamples);
          least = std::min(least, onEarth(Op::Distance, edge, leg));
        }
      }
    }
  }
  return least;
}

TEST(Fences, TheMapsDistancesAreTheSpheresAndNeverMore) {
  random_missions::Random random(1);
  int on_right_side = 0;
  for (int i = 0; i < 30; ++i) {
    const Position middle{-60 + 120 * unit(random), i % 3 == 0 ? 179.9 : -70};
    const Fence fence{
        i % 2 == 0,
        {near(middle, 0.1, random), near(middle, 0.1, random), near(middle, 0.1, random)}};
    const Places waypoints{near(middle, 0.2, random), near(middle, 0.2, random)};
    const Clearance found = AreaMap(fence.corners, waypoints).clearance(fence, waypoints);
    const double sampled = sampledDistance(fence.corners, waypoints);
    // The samples lie up to 500 m apart.
    EXPECT_LE(found.distance_m, sampled * 1.000001) << i;
    EXPECT_GE(found.distance_m, 0.85 * sampled - 500) << i;
    on_right_side += found.right_side ? 1 : 0;
  }
  EXPECT_GT(on_right_side, 3);
}

TEST(Fences, TheSideIsThatOfTheWholeHull) {
  const Places box{{39, -74}, {39, -73.5}, {39.4, -73.5}, {39.4, -74}};
  const auto right = [&](bool keep_in, const Places& waypoints) {
    return AreaMap(box, waypoints).clearance({keep_in, box}, waypoints).right_side;
  };
  EXPECT_TRUE(right(true, {{39.2, -73.8}}));
  EXPECT_FALSE(right(false, {{39.2, -73.8}}));
  EXPECT_TRUE(right(true, {{39.2, -73.8}, {39.3, -73.6}, {39.1, -73.6}}));
  EXPECT_FALSE(right(true, {{39.2, -73.8}, {39.5, -73.6}})) << "a leg leads out";
  EXPECT_FALSE(right(false, {{39.2, -74.5}, {39.2, -73}})) << "a leg leads through";
  EXPECT_FALSE(right(false, {{38, -75}, {38, -72}, {41, -73.7}})) << "the legs lead round it";
  EXPECT_TRUE(right(false, {{38, -75}, {38, -72}, {38.5, -73.7}}));
  const Places notched{{39, -74}, {39, -73}, {40, -73}, {39.1, -73.5}, {40, -74}};
  const Places over{{39.8, -73.95}, {39.8, -73.05}};
  EXPECT_FALSE(AreaMap(notched, over).clearance({true, notched}, over).right_side)
      << "both ends are inside, the leg is not";
}

std::string placeText(const Position& place) {
  return fmt::format("({}:latitude, {}:longitude)", place.latitude, place.longitude);
}

/// A mission that steers to these places in turn, 20 min each, and promises to keep in a box.
std::string boxed(const Places& waypoints, const Position& low, const Position& high) {
  std::string text =
      kHeader +
      "sensor lat: latitude vehicle m_lat id 3 encoding degrees_minutes to_si 1 lowest -9000 "
      "highest 9000 stale_after 600\n"
      "sensor lon: longitude vehicle m_lon id 4 encoding degrees_minutes to_si 1 lowest -18000 "
      "highest 18000 stale_after 600\n"
      "behaviour route nav symbol \"\" () reads ()\n";
  for (size_t i = 0; i < waypoints.size(); ++i) {
    const std::string next = i + 1 == waypoints.size() ? "exit" : fmt::format("goto s{}", i + 1);
    text += fmt::format(
        "state s{} route nav begin entry do steer_to {} end end profile glide ()\n"
        "case (ge statetime 1200:time) {}\n",
        i, placeText(waypoints[i]), next);
  }
  return text + fmt::format(
                    "require always (and (and (ge (sensor lat) {0}:latitude) (le (sensor lat) "
                    "{2}:latitude)) (and (ge (sensor lon) {1}:longitude) (le (sensor lon) "
                    "{3}:longitude))) inside ({0}, {1}, {0}, {3}, {2}, {3}, {2}, {1})\n",
                    low.latitude, low.longitude, high.latitude, high.longitude);
}

TEST(Fences, WhatIsKeptNoCurrentBreaks) {
  random_missions::Random random(7);
  constexpr int kFlights = 60;
  int proved = 0;
  int broken = 0;
  for (int i = 0; i < 60; ++i) {
    Places waypoints;
    for (uint64_t k = 0; k <= random.below(3); ++k) {
      waypoints.push_back(near({39, -73}, 0.02, random));
    }
    const double wide = 0.008 + 0.05 * unit(random);
    const Mission mission =
        missionOf(boxed(waypoints, {39 - wide, -73 - 1.2 * wide}, {39 + wide, -73 + 1.2 * wide}));
    const Ground ground(mission, slocum());
    Ending ending(ground);
    const FenceVerdict verdict = judgeFences(mission.requirements[0].fences, ground, ending);
    EXPECT_EQ(verdict.proved, verdict.reason.empty());
    bool hit = false;
    for (uint64_t seed = 0; seed < kFlights && !hit; ++seed) {
      hit = flyAtRandom(ground, 0, mission.requirements[0], seed, 1500).has_value();
    }
    EXPECT_FALSE(verdict.proved && hit) << i << ": " << wide;
    proved += verdict.proved ? 1 : 0;
    broken += hit ? 1 : 0;
  }
  EXPECT_GT(proved, 8);
  EXPECT_GT(broken, 8) << "else the flights would find nothing";
}

TEST(Fences, TheMarginGrowsWithTheTimeAndWithoutAWaypoint) {
  const Places there{{39, -73}};
  const auto margin = [&](const std::string& text) {
    const Mission mission = missionOf(text);
    const Ground ground(mission, slocum());
    Ending ending(ground);
    return judgeFences(mission.requirements[0].fences, ground, ending).margin_m;
  };
  const std::string far = boxed(there, {38.7, -73.3}, {39.3, -72.7});
  const double once = margin(far);
  const double seconds = 1200 + kResumeWithin_s;
  EXPECT_NEAR(once, slocum().world.steering_error_m + seconds * slocum().envelope.drift_m_s, 160);
  std::string by_heading = far;
  by_heading.replace(by_heading.find("steer_to"), 0, "steer (1:angle) ");
  EXPECT_NEAR(margin(by_heading) - once, seconds * slocum().world.through_water_m_s, 1e-6);
  std::string endless = far;
  endless.replace(endless.find("(ge statetime"), 13,
                  "(gt (sensor depth) 5:length) stay case (ge statetime");
  EXPECT_EQ(margin(endless), 0) << "no time by which it has ended";
}

}  // namespace
}  // namespace glider::ir::prove
