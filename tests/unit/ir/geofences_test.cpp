// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Areas to keep in and out of: the map's distances against the ellipsoid's, and what is said to be
// kept against vehicles that a current sets about.

#include "ir/prove/geometry/geofences.h"

#include "ir/eval/arithmetic.h"
#include "ir/prove/falsification/random_flight.h"
#include "ir/prove/falsification/random_place.h"
#include "ir/prove/geometry/area_map.h"
#include "ir/prove/geometry/steering.h"
#include "ir/verify/verify.h"
#include "tests/random_missions/random.h"
#include "tests/unit/ir/missions.h"
#include "tests/unit/ir/slocum.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
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

TEST(Geofences, TheMapsDistancesAreTheSpheresAndNeverMore) {
  random_missions::Random random(1);
  int on_right_side = 0;
  for (int i = 0; i < 30; ++i) {
    const Position middle{-60 + 120 * unit(random), i % 3 == 0 ? 179.9 : -70};
    const Geofence fence{
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

TEST(Geofences, TheSideIsThatOfTheWholeHull) {
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

TEST(Geofences, TheMapsDegreesAreNoLongerThanTheEllipsoids) {
  const auto apart = [](double latitude, const Position& step) {
    const Geofence fence{
        true, {{latitude - 1, -1}, {latitude - 1, 1}, {latitude + 1, 1}, {latitude + 1, -1}}};
    const Places waypoints{{latitude + step.latitude, step.longitude}};
    return AreaMap(fence.corners, waypoints).clearance(fence, waypoints).distance_m;
  };
  // WGS 84: a degree of the meridian about the equator, and of the equator.
  EXPECT_LE(apart(0, {0.5, 0}), 0.5 * 110574.4);
  EXPECT_LE(apart(0, {0, 0.5}), 0.5 * 111319.5);
}

TEST(Geofences, AMapAboutAPoleOrHalfTheEarthIsNone) {
  const auto holds = [](const Places& corners, double metres) {
    return AreaMap(corners, {corners.front()}).holds(metres);
  };
  EXPECT_TRUE(holds({{39, -74}, {39, -73}, {40, -73}}, 1e5));
  EXPECT_TRUE(holds({{39, 179}, {39, -179}, {40, -179}}, 1e5)) << "across the antimeridian";
  EXPECT_FALSE(holds({{39, -74}, {39, -73}, {40, -73}}, 4e5)) << "beyond the map's latitudes";
  EXPECT_FALSE(holds({{84, 0}, {84, 10}, {88, 5}}, 1e3));
  EXPECT_FALSE(holds({{-84, 0}, {-84, 10}, {-88, 5}}, 1e3));
  EXPECT_FALSE(holds({{0, -60}, {0, 60}, {40, 0}}, 1e3));
  EXPECT_TRUE(holds({{0, -45}, {0, 45}, {40, 0}}, 1e3)) << "as wide as it is clear";
  EXPECT_FALSE(holds({{0, -45}, {0, 45.001}, {40, 0}}, 1e3));
  EXPECT_TRUE(holds({{84, 0}, {84, 10}, {85, 5}}, 1e3)) << "as far north as degrees are alike";
  EXPECT_FALSE(holds({{84, 0}, {84, 10}, {85.001, 5}}, 1e3));
  EXPECT_TRUE(holds({{39, -74}, {39, -73}, {40, -73}}, 3 * 110574)) << "3 degrees of latitude";
  EXPECT_FALSE(holds({{39, -74}, {39, -73}, {40, -73}}, 3 * 110574 + 1));
}

/// Missions whose profile is written in the language: one in C might steer.
const std::string kAreaHeader = R"(glider_ir 1
mission m platform slocum
sensor depth: length vehicle m_depth id 1 encoding linear to_si 1 lowest -1 highest 100 stale_after 20
sensor temp: temperature vehicle sci_water_temp id 2 encoding linear to_si 1 lowest -2 highest 40 stale_after 20
sensor lat: latitude vehicle m_lat id 3 encoding degrees_minutes to_si 1 lowest -9000 highest 9000 stale_after 600
sensor lon: longitude vehicle m_lon id 4 encoding degrees_minutes to_si 1 lowest -18000 highest 18000 stale_after 600
behaviour profile level symbol "" () reads ()
behaviour profile staircase symbol gliderProfileStaircase () reads ()
behaviour route nav symbol "" () reads ()
behaviour route circuit symbol gliderRouteCircuit () reads ()
)";
const std::string kLevel = "profile level begin entry do descend (20:length, 0.4:angle) end end\n";

std::string placeText(const Position& place) {
  return fmt::format("({}:latitude, {}:longitude)", place.latitude, place.longitude);
}

std::string steerTo(const Position& place) {
  return "steer_to " + placeText(place);
}

std::string boxText(const Position& low, const Position& high) {
  return fmt::format(
      "require always (and (and (ge (sensor lat) {0}:latitude) (le (sensor lat) "
      "{2}:latitude)) (and (ge (sensor lon) {1}:longitude) (le (sensor lon) "
      "{3}:longitude))) inside ({0}, {1}, {0}, {3}, {2}, {3}, {2}, {1})\n",
      low.latitude, low.longitude, high.latitude, high.longitude);
}

/// A mission that steers to these places in turn, 20 min each, and promises to keep in a box.
/// Every other state's route commands nothing if `by_cases`: a case of the state does.
std::string boxed(const Places& waypoints, const Position& low, const Position& high,
                  bool by_cases = false) {
  std::string text = kAreaHeader;
  for (size_t i = 0; i < waypoints.size(); ++i) {
    const std::string next = i + 1 == waypoints.size() ? "exit" : fmt::format("goto s{}", i + 1);
    const bool by_case = by_cases && i % 2 == 1;
    const std::string nav = steerTo(waypoints[i]);
    text += fmt::format(
        "state s{} route nav begin {} end {}case (ge statetime 1200:time) {}\n{}", i,
        by_case ? "" : fmt::format("entry do {} end", nav), kLevel, next,
        by_case ? fmt::format("case (ge statetime 60:time) do {} end stay\n", nav) : "");
  }
  return text + boxText(low, high);
}

GeofenceVerdict judged(const std::string& text, bool keep_in = true) {
  const Mission mission = missionOf(text);
  const ProofContext proof_context(mission, slocum());
  Ending ending(proof_context);
  std::vector<Geofence> geofences = mission.requirements[0].geofences;
  for (Geofence& fence : geofences) {
    fence.keep_in = keep_in;
  }
  return judgeGeofences(geofences, proof_context, proof_context.mission.resume_within_s, ending);
}

Steering steered(const std::string& text) {
  const Mission mission = missionOf(text);
  return steeringOf(ProofContext(mission, slocum()));
}

/// Whether one of some random flights breaks the first requirement.
bool broken(const std::string& text, uint64_t flights, size_t ticks) {
  const Mission mission = missionOf(text);
  const ProofContext proof_context(mission, slocum());
  for (uint64_t seed = 0; seed < flights; ++seed) {
    if (flyAtRandom(proof_context, 3, mission.requirements[0], seed, ticks)) {
      return true;
    }
  }
  return false;
}

TEST(Geofences, WhatIsKeptNoCurrentBreaks) {
  random_missions::Random random(7);
  constexpr int kFlights = 60;
  int proved = 0;
  int left = 0;
  for (int i = 0; i < 80; ++i) {
    Places waypoints;
    for (uint64_t k = 0; k <= random.below(3); ++k) {
      waypoints.push_back(near({39, -73}, 0.02, random));
    }
    const double wide = 0.012 + 0.07 * unit(random);
    const std::string text =
        boxed(waypoints, {39 - wide, -73 - 1.2 * wide}, {39 + wide, -73 + 1.2 * wide}, i % 2 == 0);
    const GeofenceVerdict verdict = judged(text);
    EXPECT_EQ(verdict.proved, verdict.reason.empty());
    const bool hit = broken(text, kFlights, 1500);
    EXPECT_FALSE(verdict.proved && hit) << i << ": " << wide;
    proved += verdict.proved ? 1 : 0;
    left += hit ? 1 : 0;
  }
  EXPECT_GT(proved, 8);
  EXPECT_GT(left, 8) << "else the flights would find nothing";
}

/// How far off the map's straight line the shortest way between two places is half way, m.
double bendBetween(const Position& a, const Position& b) {
  constexpr double kRadian = std::numbers::pi / 180;
  const auto point = [](const Position& p) {
    const double north = p.latitude * kRadian;
    const double east = p.longitude * kRadian;
    return std::array{std::cos(north) * std::cos(east), std::cos(north) * std::sin(east),
                      std::sin(north)};
  };
  const auto from = point(a);
  const auto to = point(b);
  const double x = from[0] + to[0];
  const double y = from[1] + to[1];
  const double z = from[2] + to[2];
  const Position half{std::atan2(z, std::hypot(x, y)) / kRadian, std::atan2(y, x) / kRadian};
  return onEarth(Op::Distance, half, between(a, b, 0.5));
}

TEST(Geofences, AWayFromFarOffBendsIntoAnAreaToKeepOutOf) {
  const Position waypoint{60, 0};
  const GeofenceVerdict verdict = judged(boxed({waypoint}, {60.1, -0.3}, {60.2, 0.3}), false);
  ASSERT_TRUE(verdict.proved) << verdict.reason;
  ASSERT_GT(verdict.start_within_m, 0) << "from half round the Earth it might come over the pole";
  const platforms::EnvironmentModel& world = slocum().world;
  const double off_legs = world.steering_error_m +
                          (1200 + kResumeWithin_s) * world.surface_drift_m_s +
                          kResumeWithin_s * world.through_water_m_s;
  const double degrees = verdict.start_within_m / (111195 * 0.5);
  const double bend = bendBetween({60, -degrees}, waypoint);
  EXPECT_GT(bend, 50);
  EXPECT_GE(verdict.margin_m, off_legs + bend);
  EXPECT_EQ(judged(boxed({waypoint}, {59, -2}, {61, 2})).start_within_m, 0);
}

TEST(Geofences, TheMarginGrowsWithTheTimeAndWithoutAWaypoint) {
  const std::string far = boxed({{39, -73}}, {38.7, -73.3}, {39.3, -72.7});
  const double once = judged(far).margin_m;
  const platforms::EnvironmentModel& world = slocum().world;
  const double seconds = 1200 + kResumeWithin_s;
  const double dark = kResumeWithin_s * world.through_water_m_s;
  EXPECT_NEAR(once, world.steering_error_m + seconds * world.surface_drift_m_s + dark, 160);
  EXPECT_GT(world.surface_drift_m_s, slocum().envelope.drift_m_s);
  std::string by_heading = far;
  by_heading.replace(by_heading.find("steer_to"), 0, "steer (1:angle) ");
  const double astray = (seconds - kResumeWithin_s) * world.through_water_m_s;
  EXPECT_NEAR(judged(by_heading).margin_m - once, astray, 1e-6);
  std::string endless = far;
  endless.replace(endless.find("(ge statetime"), 13,
                  "(gt (sensor depth) 5:length) stay case (ge statetime");
  EXPECT_EQ(judged(endless).margin_m, 0) << "no time by which it has ended";
  std::string long_dark = far;
  long_dark.replace(long_dark.find("sensor depth"), 0, "resume within 600\n");
  EXPECT_NEAR(judged(long_dark).margin_m - once, (600 - kResumeWithin_s) * world.through_water_m_s,
              700)
      << "the mission's end may come later too";
  EXPECT_GT(judged(long_dark).margin_m, once + 100);
}

/// A mission of two states; `at` says where to put a command, which is all that differs.
std::string withCommandAt(size_t at, const std::string& command) {
  std::vector<std::string> places(9);
  places.at(at) = command;
  return kAreaHeader +
         fmt::format(
             "always case (gt (sensor depth) 90:length) do {0} end goto b\n"
             "state a route nav begin entry do {9} {1} end case (known (sensor temp)) do {2} end "
             "stay "
             "end\nprofile level begin entry do descend (20:length, 0.4:angle) {3} end "
             "case (known (sensor depth)) do {4} end stay end\n"
             "entry do {5} end case (ge statetime 900:time) goto b "
             "case (gt (sensor temp) 30:temperature) do {6} end stay\n"
             "state b route nav begin end {10} case (ge statetime 900:time) do {8} end exit "
             "case (gt (sensor temp) 30:temperature) do if (known (sensor lat)) else {7} end end "
             "stay\n",
             places[0], places[1], places[2], places[3], places[4], places[5], places[6], places[7],
             places[8], steerTo({39, -73}), kLevel) +
         boxText({38.9, -73.1}, {39.1, -72.9});
}

TEST(Geofences, CommandsSteerWhereverTheyAreWritten) {
  const GeofenceVerdict without = judged(withCommandAt(0, ""));
  EXPECT_TRUE(without.proved) << without.reason << ": b's route commands nothing, a's holds";
  EXPECT_FALSE(steered(withCommandAt(0, "")).by_heading);
  const Position far{39, -72.5};
  for (size_t at = 0; at < 9; ++at) {
    const Steering steering = steered(withCommandAt(at, steerTo(far)));
    EXPECT_TRUE(std::ranges::find(steering.waypoints, far) != steering.waypoints.end()) << at;
    EXPECT_FALSE(judged(withCommandAt(at, steerTo(far))).proved) << at;
    EXPECT_TRUE(steered(withCommandAt(at, "steer (1:angle)")).by_heading) << at;
    EXPECT_TRUE(steered(withCommandAt(at, "drift ()")).by_heading) << at;
    EXPECT_TRUE(steered(withCommandAt(at, "fin (0.1:angle)")).by_heading) << at;
    EXPECT_FALSE(steered(withCommandAt(at, "surface ()")).by_heading) << at;
  }
}

TEST(Geofences, RandomFlightsFollowCommandsOfCases) {
  // One that is given control inside, and leaves by the command of a case alone.
  const auto leaves = [](const std::string& command) {
    std::string text = withCommandAt(6, command);
    text = text.substr(0, text.find("require")) + boxText({38.97, -73.02}, {39.03, -72.981});
    const Mission mission = missionOf(text);
    const ProofContext proof_context(mission, slocum());
    int left = 0;
    for (uint64_t seed = 0; seed < 200; ++seed) {
      const auto run = flyAtRandom(proof_context, 3, mission.requirements[0], seed, 800);
      left += run && run->when > 60 ? 1 : 0;
    }
    return left;
  };
  EXPECT_EQ(leaves(""), 0);
  EXPECT_GT(leaves(steerTo({39, -72.9})), 3);
}

/// The bearings of the way of each of three legs of 4 s, rad, in still water.
std::array<double, 3> waysUnder(const CommandRun& command) {
  platforms::Platform still = slocum();
  still.envelope.drift_m_s = still.world.surface_drift_m_s = 0;
  Rng rng(1);
  RandomPlace place({39, -73}, still, rng);
  place.obey({command});
  std::array<double, 3> ways{};
  for (double& way : ways) {
    const Position before = place.where();
    place.move(4, false, false);
    way = onEarth(Op::Bearing, before, place.where());
  }
  return ways;
}

TEST(Geofences, RandomFlightsTurnUnderAHeldFin) {
  const auto turns = [](const CommandRun& command) {
    const auto ways = waysUnder(command);
    const double first = std::remainder(ways[1] - ways[0], 2 * std::numbers::pi);
    const double second = std::remainder(ways[2] - ways[1], 2 * std::numbers::pi);
    EXPECT_NEAR(first, second, 1e-3) << "steadily";
    return first;
  };
  EXPECT_GT(turns({Command::Fin, {0.2}}), 0.01);
  EXPECT_LT(turns({Command::Fin, {-0.2}}), -0.01);
  EXPECT_NEAR(turns({Command::Fin, {0.4}}) / turns({Command::Fin, {0.2}}),
              std::sin(0.4) / std::sin(0.2), 0.02);
  EXPECT_NEAR(turns({Command::Fin, {0}}), 0, 1e-3);
  EXPECT_NEAR(turns({Command::Drift, {}}), 0, 1e-3);
  EXPECT_NEAR(turns({Command::Steer, {1}}), 0, 1e-3);
}

/// A mission whose first route has this entry; `variables` stand above.
std::string beginning(const std::string& entry, const std::string& variables = "") {
  return kAreaHeader + variables + "state a route nav begin entry do " + entry +
         " end case (ge statetime 60:time) do " + steerTo({39, -73}) + " end stay end " + kLevel +
         "case (ge statetime 900:time) exit\n" + boxText({38.9, -73.1}, {39.1, -72.9});
}

TEST(Geofences, WithoutAHeadingAtFirstItGoesAnywhere) {
  const std::string here = steerTo({39, -73});
  const std::string leg =
      "table latitude (39.0, 39.01)\ntable longitude (-73.0, -73.01)\n"
      "variable leg: number mission lowest 0 highest 1\ninitial leg 0\n";
  const std::string nowhere = "variable to: latitude mission\ninitial to (sensor lat)\n";
  const auto free = [](const std::string& text) { return steered(text).by_heading; };
  EXPECT_FALSE(free(beginning(here)));
  EXPECT_TRUE(free(beginning("")));
  EXPECT_TRUE(free(beginning("if (known (sensor lat)) " + here + " end")));
  EXPECT_TRUE(
      free(beginning("if (gt (sensor temp) 3:temperature) " + here + " else " + here + " end")))
      << "an unknown condition takes neither branch";
  EXPECT_FALSE(free(beginning("if (known (sensor lat)) " + here + " else " + here + " end")));
  EXPECT_TRUE(free(beginning("if (known (sensor lat)) else " + here + " end")));
  const std::string on_path = "steer_to ((element 0 %9), (element 1 %9))";
  EXPECT_FALSE(free(beginning(on_path, leg + "let %9 = (var leg)\n")));
  EXPECT_TRUE(free(beginning(on_path, leg + "let %9 = (add (var leg) 2)\n")))
      << "the path has no such place";
  EXPECT_TRUE(free(beginning("steer_to ((var to), -73:longitude)", nowhere)))
      << "a command with an unknown argument changes nothing";
  const double margin = judged(beginning("")).margin_m - judged(beginning(here)).margin_m;
  EXPECT_GT(margin, 0.5 * 900 * slocum().world.through_water_m_s);
}

/// A mission that steers to (39, -73) at first and later where `command` says.
Steering steeredLater(const std::string& command, const std::string& variables = "") {
  std::string text = beginning(steerTo({39, -73}), variables);
  const std::string later = "do " + steerTo({39, -73}) + " end stay end";
  text.replace(text.find(later), later.size(), "do " + command + " end stay end");
  return steered(text);
}

TEST(Geofences, APlaceThatIsComputedLiesInItsBox) {
  const auto within = [](const std::string& north, const std::string& east) {
    return steeredLater("steer_to ((var n), (var e))",
                        "variable n: latitude mission " + north + " initial n 38.5:latitude\n" +
                            "variable e: longitude mission " + east + " initial e 20:longitude\n");
  };
  const Steering box = within("lowest 38 highest 39.5", "lowest -74 highest 20");
  EXPECT_FALSE(box.by_heading);
  for (const Position corner :
       {Position{38, -74}, Position{38, 20}, Position{39.5, -74}, Position{39.5, 20}}) {
    EXPECT_TRUE(std::ranges::find(box.waypoints, corner) != box.waypoints.end())
        << corner.latitude << " " << corner.longitude;
  }
  const auto anywhere = [&](const std::string& north, const std::string& east) {
    return within(north, east).by_heading;
  };
  const std::string there = "lowest 38 highest 39";
  EXPECT_TRUE(anywhere("", "lowest 19 highest 21"));
  EXPECT_TRUE(anywhere(there, ""));
  EXPECT_TRUE(anywhere("lowest -90 highest 39", "lowest 19 highest 21")) << "a pole";
  EXPECT_FALSE(anywhere("lowest -89 highest 39", "lowest 19 highest 21"));
  EXPECT_TRUE(anywhere("lowest 38 highest 90", "lowest 19 highest 21"));
  EXPECT_FALSE(anywhere("lowest 38 highest 89", "lowest 19 highest 21"));
  EXPECT_TRUE(anywhere(there, "lowest -100 highest 80")) << "either way round the Earth";
  EXPECT_FALSE(anywhere(there, "lowest -100 highest 79"));
  EXPECT_FALSE(anywhere(there, "lowest 20 highest 170"));
}

const std::string kLeg =
    "table latitude (39.0, 39.01)\ntable longitude (-73.0, -73.01)\n"
    "table longitude (-73.0, -73.01, -73.02)\n"
    "variable leg: number mission lowest 0 highest 1\ninitial leg 0\n"
    "variable other: number mission lowest 0 highest 1\ninitial other 0\n";

TEST(Geofences, APathIsItsPlacesWhereOneRowGivesBoth) {
  const auto anywhere = [](const std::string& east) {
    return steeredLater("steer_to ((element 0 %9), " + east + ")",
                        kLeg + "let %9 = (var leg)\nlet %10 = (var other)\n")
        .by_heading;
  };
  EXPECT_FALSE(anywhere("(element 1 %9)"));
  EXPECT_FALSE(anywhere("(element 1 (var leg))")) << "written twice, it is the same row";
  EXPECT_TRUE(anywhere("(element 1 (sub 1 (var leg)))"));
  EXPECT_TRUE(anywhere("(element 1 %10)")) << "any of the one with any of the other";
  EXPECT_TRUE(anywhere("(element 2 %9)")) << "tables of different lengths are not a path";
}

TEST(Geofences, AnyEntryOfTheStartMayCommandTheHeading) {
  const std::string here = steerTo({39, -73});
  const std::string none = beginning("");
  const auto free = [](const std::string& text) { return steered(text).by_heading; };
  EXPECT_TRUE(free(none)) << "a depth command is not a heading";
  std::string by_state = none;
  by_state.replace(by_state.find("case (ge statetime 900"), 0, "entry do " + here + " end ");
  EXPECT_FALSE(free(by_state));
  std::string by_profile = none;
  by_profile.replace(by_profile.find("descend ("), 0, here + " ");
  EXPECT_FALSE(free(by_profile));
}

TEST(Geofences, AtFirstARowMayBeNone) {
  const auto free = [](const std::string& row, const std::string& before = "",
                       const std::string& after = "") {
    return steered(beginning(before + "steer_to ((element 0 %9), (element 1 %9))" + after,
                             kLeg +
                                 "variable wide: number mission lowest 0 highest 9\n"
                                 "initial wide 0\nlet %9 = " +
                                 row + "\n"))
        .by_heading;
  };
  EXPECT_FALSE(free("1"));
  EXPECT_TRUE(free("0.5"));
  EXPECT_TRUE(free("2"));
  EXPECT_TRUE(free("-1"));
  EXPECT_TRUE(free("(sub (var leg) 1)"));
  EXPECT_TRUE(free("(mul 1e300 1e300)"));
  EXPECT_FALSE(free("(select (known (sensor temp)) 1 0)"));
  EXPECT_TRUE(free("(select (gt (sensor temp) 3:temperature) 1 0)")) << "unknown, maybe";
  EXPECT_FALSE(free("(var leg)", "if (known (sensor temp)) set leg 1 end "));
  EXPECT_TRUE(free("(var wide)", "if (known (sensor temp)) set wide 2 end "))
      << "what the entry sets";
  EXPECT_TRUE(free("(var wide)", "set wide 2 ", " set wide 0"))
      << "as it stood between two statements";
  EXPECT_TRUE(free("(var leg)", "set leg (clamp (div (sensor depth) 100:length) 0 1) "))
      << "no whole number";
}

TEST(Geofences, WhatIsWrittenInCMaySteerAnywhere) {
  std::string text = beginning(steerTo({39, -73}));
  EXPECT_FALSE(steered(text).by_heading);
  std::string profile = text;
  profile.replace(profile.find(kLevel), kLevel.size(), "profile staircase ()\n");
  EXPECT_TRUE(steered(profile).by_heading);
  const size_t route = text.find("route nav begin");
  text.replace(route, text.find("profile level begin") - route, "route circuit () ");
  EXPECT_TRUE(steered(text).by_heading);
}

TEST(Geofences, AtTheSurfaceAndWhileDarkRandomFlightsGoFurther) {
  const Position start{39, -73};
  double under = 0;
  double at_surface = 0;
  double dark = 0;
  for (uint64_t seed = 0; seed < 40; ++seed) {
    const auto moved = [&](bool surface, bool without_sbc) {
      Rng dice(seed);
      RandomPlace place(start, slocum(), dice);
      place.obey({CommandRun{Command::SteerTo, {start.latitude, start.longitude}, false}});
      place.move(300, surface, without_sbc);
      return onEarth(Op::Distance, start, place.where());
    };
    under = std::max(under, moved(false, false));
    at_surface = std::max(at_surface, moved(true, false));
    dark = std::max(dark, moved(true, true));
  }
  EXPECT_NEAR(under, 300 * slocum().envelope.drift_m_s, 1);
  EXPECT_NEAR(at_surface, 300 * slocum().world.surface_drift_m_s, 1);
  EXPECT_GT(dark, at_surface + 60);
}

/// It gets ahead only while it dives or climbs; one with a propeller also at the surface.
TEST(Geofences, RandomFlightsGlideOnlyUnderWater) {
  const auto moved = [](platforms::Platform vehicle, bool surface) {
    vehicle.envelope.drift_m_s = vehicle.world.surface_drift_m_s = 0;
    Rng dice(1);
    RandomPlace place({39, -73}, vehicle, dice);
    place.obey({CommandRun{Command::Steer, {1}, false}});
    place.move(300, surface, false);
    return onEarth(Op::Distance, {39, -73}, place.where());
  };
  EXPECT_GT(moved(slocum(), false), 10);
  EXPECT_NEAR(moved(slocum(), true), 0, 1e-3);
  platforms::Platform propelled = slocum();
  propelled.envelope.fastest_m_s = 2;
  EXPECT_GT(moved(propelled, true), 10);
}

TEST(Geofences, RandomFlightsTakeAProfileInCToSteer) {
  Rng dice(1);
  RandomPlace place({39, -73}, slocum(), dice);
  place.obey({CommandRun{Command::SteerTo, {39, -73}, false},
              ActivityRun{ListKind::Profile, {}, Phase::Tick, {}}});
  place.move(3600, false, false);
  EXPECT_GT(onEarth(Op::Distance, {39, -73}, place.where()),
            1.01 * 3600 * slocum().envelope.drift_m_s);
}

}  // namespace
}  // namespace glider::ir::prove
