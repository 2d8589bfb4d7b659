// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Discs to keep in and out of: the map's clearance against places that are tried one by one, and
// what is said to be kept against vehicles that a current sets about.

#include "ir/core/inside.h"
#include "ir/eval/arithmetic.h"
#include "ir/prove/falsification/random_flight.h"
#include "ir/prove/geometry/area_map.h"
#include "ir/prove/geometry/geofences.h"
#include "ir/text/print.h"
#include "ir/verify/verify.h"
#include "tests/random_missions/random.h"
#include "tests/unit/ir/missions.h"
#include "tests/unit/ir/slocum.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace glider::ir::prove {
namespace {

using Places = std::vector<Position>;

constexpr double kRadianOfDegree = std::numbers::pi / 180;
constexpr double kShortestDegree = 110574;  // m, of latitude on WGS 84

double uniform(random_missions::Random& random) {
  return static_cast<double>(random.below(1U << 20)) / (1U << 20);
}

Position around(const Position& middle, double degrees, random_missions::Random& random) {
  const double wide = degrees / std::cos(middle.latitude * kRadianOfDegree);
  return {middle.latitude + degrees * (2 * uniform(random) - 1),
          middle.longitude + wide * (2 * uniform(random) - 1)};
}

/// The same place with a longitude of -180 to 180 degrees.
Position wrapped(const Position& place) {
  return {place.latitude, std::remainder(place.longitude, 360)};
}

/// Any place in the hull of some.
Position among(const Places& places, random_missions::Random& random) {
  Position at = places.front();
  for (const Position& place : places) {
    const double share = random.chance(0.3) ? 1 : uniform(random);
    at.latitude += share * (place.latitude - at.latitude);
    at.longitude += share * (place.longitude - at.longitude);
  }
  return at;
}

/// The place after a way over the ellipsoid of WGS 84 that is `metres` long.
Position after(const Position& from, double metres, double course) {
  constexpr double kEquator = 6378137;
  constexpr double kEccentricity2 = 0.00669437999;
  const double sine = std::sin(from.latitude * kRadianOfDegree);
  const double w = 1 - kEccentricity2 * sine * sine;
  const double meridian = kEquator * (1 - kEccentricity2) / (w * std::sqrt(w));
  const double parallel = kEquator / std::sqrt(w) * std::cos(from.latitude * kRadianOfDegree);
  return {from.latitude + metres * std::cos(course) / meridian / kRadianOfDegree,
          from.longitude + metres * std::sin(course) / parallel / kRadianOfDegree};
}

/// In the Southern and the Northern Hemisphere, at the equator, at the antimeridian, near a pole.
const Places kMiddles{{-52, -70}, {39, -73}, {0.02, 10}, {61, 179.98}, {-8, -179.99}, {80, 20}};

TEST(Discs, NoPlaceWithinTheClearanceIsAcrossTheEdge) {
  random_missions::Random random(1);
  int right = 0;
  for (int i = 0; i < 400; ++i) {
    const Position middle = kMiddles[static_cast<size_t>(i) % kMiddles.size()];
    const bool keep_in = i % 2 == 0;
    const double radius = (keep_in ? 4000 : 500) + 40000 * uniform(random);
    const Geofence disc{keep_in, {around(middle, 0.05, random)}, radius};
    const double wide = keep_in ? 0.1 : 0.8;
    Places waypoints{around(middle, wide, random), around(middle, wide, random)};
    waypoints.push_back(around(waypoints.front(), 0.1, random));
    const AreaMap map(disc, waypoints);
    const Clearance found = map.clearance(disc, waypoints);
    if (!found.right_side || !map.holds(found.distance_m)) {
      continue;
    }
    ++right;
    for (int k = 0; k < 300; ++k) {
      const Position place = after(among(waypoints, random), 0.999 * found.distance_m,
                                   2 * std::numbers::pi * uniform(random));
      const double distance = onEarth(Op::Distance, place, disc.corners.front());
      ASSERT_EQ(distance < radius, keep_in) << i << ": " << distance << " of " << radius;
    }
  }
  EXPECT_GT(right, 100);
}

TEST(Discs, TheClearanceIsNotMuchLessThanThereIs) {
  for (const Position& middle : kMiddles) {
    const double degree = 6371008.8 * kRadianOfDegree;
    const Places there{{middle.latitude + 20000 / degree, middle.longitude}};
    const Geofence in{true, {middle}, 30000};
    const Geofence out{false, {middle}, 10000};
    const double share = std::fabs(middle.latitude) < 70 ? 0.8 : 0.6;
    EXPECT_GT(AreaMap(in, there).clearance(in, there).distance_m, share * 10000);
    EXPECT_LT(AreaMap(in, there).clearance(in, there).distance_m, 10000);
    EXPECT_GT(AreaMap(out, there).clearance(out, there).distance_m, 9850);
    EXPECT_LT(AreaMap(out, there).clearance(out, there).distance_m, 10000);
  }
}

TEST(Discs, TheSideIsThatOfTheWholeHull) {
  const Position home{39, -73};
  const auto right = [&](bool keep_in, double radius, const Places& waypoints) {
    const Geofence disc{keep_in, {home}, radius};
    return AreaMap(disc, waypoints).clearance(disc, waypoints).right_side;
  };
  EXPECT_TRUE(right(true, 3000, {home}));
  EXPECT_FALSE(right(false, 3000, {home}));
  EXPECT_FALSE(right(true, 3000, {home, {39.04, -73}})) << "a leg leads out";
  EXPECT_FALSE(right(false, 3000, {{38.9, -73.1}, {39.1, -72.9}})) << "a leg leads through";
  EXPECT_FALSE(right(false, 3000, {{38, -74}, {38, -72}, {41, -73}})) << "the legs lead round it";
  EXPECT_TRUE(right(false, 3000, {{38, -74}, {38, -72}, {38.9, -73}}));
}

TEST(Discs, AboutAPoleOrHalfTheEarthHaveNoMap) {
  const auto holds = [](const Position& centre, double radius) {
    const Geofence disc{true, {centre}, radius};
    return AreaMap(disc, {centre}).holds(1000);
  };
  EXPECT_TRUE(holds({39, -73}, 3000));
  EXPECT_TRUE(holds({39, 179.999}, 3000)) << "across the antimeridian";
  EXPECT_TRUE(holds({84.9, 0}, 3000));
  EXPECT_FALSE(holds({84.99, 0}, 3000)) << "its north is nearer to the pole";
  EXPECT_FALSE(holds({-89.99, 0}, 3000)) << "the pole is in it";
  EXPECT_FALSE(holds({39, -73}, 9e6));
}

std::string missionText(const Places& waypoints, const std::string& condition,
                        const std::string& fence) {
  std::string text = R"(glider_ir 1
mission m platform slocum
sensor depth: length vehicle m_depth id 1 encoding linear to_si 1 lowest -1 highest 100 stale_after 20
sensor lat: latitude vehicle m_lat id 3 encoding degrees_minutes to_si 1 lowest -9000 highest 9000 stale_after 600
sensor lon: longitude vehicle m_lon id 4 encoding degrees_minutes to_si 1 lowest -18000 highest 18000 stale_after 600
behaviour profile level symbol "" () reads ()
behaviour route nav symbol "" () reads ()
)";
  for (size_t i = 0; i < waypoints.size(); ++i) {
    text += fmt::format(
        "state s{} route nav begin entry do steer_to ({}:latitude, {}:longitude) end end "
        "profile level begin entry do descend (20:length, 0.4:angle) end end\n"
        "case (ge statetime 1200:time) {}\n",
        i, waypoints[i].latitude, waypoints[i].longitude,
        i + 1 == waypoints.size() ? "exit" : fmt::format("goto s{}", i + 1));
  }
  return text + "require always " + condition + " " + fence + "\n";
}

/// Keeps closer to a place than `radius`, or farther.
std::string discText(const Places& waypoints, const Position& centre, double radius, bool keep_in) {
  return missionText(
      waypoints,
      fmt::format("({} (distance (sensor lat) (sensor lon) {}:latitude {}:longitude) {}:length)",
                  keep_in ? "lt" : "gt", centre.latitude, centre.longitude, radius),
      fmt::format("{} {} ({}, {})", keep_in ? "closer" : "farther", radius, centre.latitude,
                  centre.longitude));
}

GeofenceVerdict judgedDisc(const Mission& mission) {
  const ProofContext proof_context(mission, slocum());
  Ending ending(proof_context);
  return judgeGeofences(mission.requirements[0].geofences, proof_context, mission.resume_within_s,
                        ending);
}

bool isBroken(const Mission& mission, uint64_t flights, size_t ticks) {
  const ProofContext proof_context(mission, slocum());
  for (uint64_t seed = 0; seed < flights; ++seed) {
    if (flyAtRandom(proof_context, 3, mission.requirements[0], seed, ticks)) {
      return true;
    }
  }
  return false;
}

TEST(Discs, ThatAreKeptNoCurrentBreaks) {
  random_missions::Random random(7);
  constexpr int kFlights = 40;
  int proved[2] = {0, 0};
  int left[2] = {0, 0};
  for (int i = 0; i < 120; ++i) {
    const Position middle = kMiddles[random.below(kMiddles.size())];
    const bool keep_in = i % 2 == 0;
    Places waypoints;
    for (uint64_t k = 0; k <= random.below(3); ++k) {
      waypoints.push_back(wrapped(around(middle, 0.02, random)));
    }
    const double radius = 500 + (keep_in ? 12000 : 3000) * uniform(random);
    const double apart = keep_in ? 0.01 : i % 4 == 1 ? 0.03 : 0.15;
    const Position centre = wrapped(around(middle, apart, random));
    const Mission mission = missionOf(discText(waypoints, centre, radius, keep_in));
    const GeofenceVerdict verdict = judgedDisc(mission);
    EXPECT_EQ(verdict.proved, verdict.reason.empty());
    const bool hit = isBroken(mission, kFlights, 1500);
    EXPECT_FALSE(verdict.proved && hit) << i << ": " << radius << "\n" << print(mission);
    proved[keep_in ? 1 : 0] += verdict.proved ? 1 : 0;
    left[keep_in ? 1 : 0] += hit ? 1 : 0;
  }
  for (const int i : {0, 1}) {
    EXPECT_GT(proved[i], 5) << i;
    EXPECT_GT(left[i], 5) << i << ", else the flights would find nothing";
  }
}

TEST(Discs, ThePremiseIsMeasuredAsDistanceMeasures) {
  const Position home{60, 5};
  const GeofenceVerdict verdict = judgedDisc(missionOf(discText({home}, home, 20000, true)));
  ASSERT_TRUE(verdict.proved) << verdict.reason;
  const platforms::EnvironmentModel& world = slocum().world;
  const double off_legs = world.steering_error_m +
                          (1200 + kResumeWithin_s) * world.surface_drift_m_s +
                          kResumeWithin_s * world.through_water_m_s;
  EXPECT_GE(verdict.margin_m,
            off_legs * std::cos(60 * kRadianOfDegree) / std::cos(63 * kRadianOfDegree));
  EXPECT_LE(verdict.margin_m, 1.3 * off_legs);
  EXPECT_EQ(verdict.start_within_m, 0);

  const GeofenceVerdict out = judgedDisc(missionOf(discText({home}, {60.3, 5}, 5000, false)));
  ASSERT_GT(out.start_within_m, 0);
  const Geofence disc{false, {{60.3, 5}}, 5000};
  const AreaMap map(disc, {home});
  EXPECT_GE(out.margin_m,
            (off_legs + map.bend_m(out.start_within_m)) * map.stretch(out.start_within_m))
      << "control may be given far from the waypoints, where the map is narrower";
}

TEST(Discs, ContainAllOfTheStartThatIsAssumed) {
  const Position home{39, -73};
  const auto proved = [&](double radius, bool keep_in, const Position& centre, double north) {
    return judgedDisc(missionOf(fmt::format("{}assume \"start\" start inside (39, -73.01, {}, -73, "
                                            "39, -72.99)\n",
                                            discText({home}, centre, radius, keep_in), north)))
        .proved;
  };
  EXPECT_TRUE(proved(10000, true, home, 39.02));
  EXPECT_FALSE(proved(10000, true, home, 39.1)) << "one corner is outside";
  EXPECT_TRUE(proved(10000, false, {39.2, -73}, 39.01));
  EXPECT_FALSE(proved(10000, false, {39.2, -73}, 39.4)) << "the way from a corner leads through";
}

TEST(Discs, AreWrittenAndReadAsTheyWere) {
  const Mission mission = missionOf(discText({{39, -73}}, {39.25, -73}, 2500.5, false));
  const std::string text = print(mission);
  EXPECT_NE(text.find(" farther 2500.5 (39.25, -73)"), std::string::npos) << text;
  EXPECT_EQ(missionOf(text).requirements[0].geofences, mission.requirements[0].geofences);
}

TEST(Discs, AboutAPoleAreNotBrokenByAFlightThatJumps) {
  const Position polar{89.99, 10};
  EXPECT_FALSE(isBroken(missionOf(discText({polar}, polar, 9000, true)), 20, 300));
}

/// Readings alone do not violate a condition about the place that is not a geofence: the flight
/// begins where the mission may.
TEST(Discs, APlaceInAnotherConditionIsWhereAFlightMayBe) {
  const std::string near_home =
      "(or (lt (distance (sensor lat) (sensor lon) 39:latitude -73:longitude) 30000:length) (ge "
      "(sensor depth) 90:length))";
  EXPECT_FALSE(isBroken(missionOf(missionText({{39, -73}}, near_home, "")), 60, 1500));
  EXPECT_TRUE(isBroken(missionOf(missionText({{39.4, -73}}, near_home, "")), 60, 1500));
}

/// The place on the mission's sphere at a bearing (rad) and a distance (m) from another.
Position reached(const Position& from, double bearing, double metres) {
  constexpr double kRadius = 6371008.8;
  const double way = metres / kRadius, north = from.latitude * kRadianOfDegree;
  const double latitude = std::asin(std::sin(north) * std::cos(way) +
                                    std::cos(north) * std::sin(way) * std::cos(bearing));
  const double turned = std::atan2(std::sin(bearing) * std::sin(way) * std::cos(north),
                                   std::cos(way) - std::sin(north) * std::sin(latitude));
  return {latitude / kRadianOfDegree,
          std::remainder(from.longitude + turned / kRadianOfDegree, 360)};
}

TEST(Discs, ThePolygonAroundADiscHoldsItAndIsHardlyWider) {
  for (const double latitude : {-79.7, -45.0, 0.0, 39.0, 70.0, 79.7}) {
    for (const double radius_m : {1.0, 300.0, 20000.0}) {
      const Geofence disc{true, {{latitude, 179.95}}, radius_m};
      const auto polygon = polygonAround(disc);
      ASSERT_TRUE(polygon.has_value());
      EXPECT_TRUE(polygon->keep_in);
      EXPECT_FALSE(polygon->isDisc());
      for (int degree = 0; degree < 360; ++degree) {
        EXPECT_TRUE(
            isInside(*polygon, reached(disc.corners[0], degree * kRadianOfDegree, radius_m)))
            << latitude << " " << radius_m << " " << degree;
        EXPECT_FALSE(
            isInside(*polygon, reached(disc.corners[0], degree * kRadianOfDegree, 1.07 * radius_m)))
            << latitude << " " << radius_m << " " << degree;
      }
    }
  }
  EXPECT_FALSE(polygonAround({true, {{39, -73}}, 20001}).has_value());
  EXPECT_FALSE(polygonAround({true, {{79.9, -73}}, 20000}).has_value());
}

}  // namespace
}  // namespace glider::ir::prove
