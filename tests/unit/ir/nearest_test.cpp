// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What is far from all else, against the comparison of all pairs.

#include "ir/prove/geometry/nearest.h"

#include "ir/eval/arithmetic.h"
#include "ir/prove/context/commands.h"
#include "ir/prove/geometry/sphere.h"
#include "ir/prove/prove.h"
#include "ir/verify/verify.h"
#include "support/diagnostics/ids/verification.h"
#include "tests/random_missions/random.h"
#include "tests/unit/ir/missions.h"
#include "tests/unit/ir/slocum.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace glider::ir::prove {
namespace {

using random_missions::Random;

constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// Places in clusters, with doubles, about the poles, across the antimeridian and anywhere.
Position anyPlace(Random& random, const std::vector<Position>& before) {
  switch (random.below(6)) {
    case 0:
      return before.empty() ? Position{1, 1} : random.pick(before);
    case 1:
      return {random.uniform(88, 90), random.uniform(-180, 180)};
    case 2:
      return {random.uniform(-1, 1), random.chance(0.5) ? 180.0 : random.uniform(-181, -179)};
    case 3:
      return {39.0, -74.0 + 0.001 * random.below(4)};
    default:
      return {random.uniform(-90, 90), random.uniform(-180, 180)};
  }
}

double bruteNearest(const Position& place, const std::vector<Position>& places) {
  double nearest = kInfinite;
  for (const Position& other : places) {
    const double metres = onEarth(Op::Distance, place, other);
    nearest = metres > 0 ? std::min(nearest, metres) : nearest;
  }
  return nearest;
}

TEST(Nearest, PlacesAreAsFarApartAsAllPairsSay) {
  Random random(3);
  for (int i = 0; i < 60; ++i) {
    std::vector<Position> places;
    for (uint64_t k = 0; k < random.below(60); ++k) {
      places.push_back(anyPlace(random, places));
    }
    const PlaceIndex index(places);
    for (const Position& place : places) {
      EXPECT_EQ(index.nearestOther(place), bruteNearest(place, places)) << i;
    }
  }
  EXPECT_EQ(PlaceIndex({}).nearestOther({1, 2}), kInfinite);
  EXPECT_EQ(PlaceIndex({{1, 2}}).nearestOther({1, 2}), kInfinite);
  EXPECT_EQ(PlaceIndex({{0, 180}, {0, -180}}).nearestOther({0, 180}), kInfinite);
}

TEST(Nearest, CountsWithinADistanceAreThoseOfAllPairs) {
  Random random(6);
  for (int i = 0; i < 200; ++i) {
    std::vector<Position> places;
    for (uint64_t k = 0; k < random.below(30); ++k) {
      const bool again = !places.empty() && random.chance(0.3);
      places.push_back(again ? random.pick(places)
                             : Position{random.uniform(-90, 90), random.uniform(-180, 180)});
    }
    const PlaceIndex index(places);
    const Position here =
        places.empty() || random.chance(0.5) ? Position{random.uniform(-90, 90), 179} : places[0];
    const double metres = random.uniform(0, 1.5e7);
    const auto around = static_cast<size_t>(std::ranges::count_if(
        places, [&](const Position& p) { return onEarth(Op::Distance, here, p) < metres; }));
    EXPECT_TRUE(index.hasAround(here, metres, around)) << i;
    EXPECT_FALSE(index.hasAround(here, metres, around + 1)) << i;
    EXPECT_EQ(index.timesGiven(here), static_cast<size_t>(std::ranges::count(places, here))) << i;
  }
}

double bruteOnCircle(double angle, const std::vector<double>& angles) {
  double nearest = kInfinite;
  for (const double other : angles) {
    const double apart = std::fabs(std::remainder(angle - other, 360));
    nearest = apart > 0 ? std::min(nearest, apart) : nearest;
  }
  return nearest;
}

TEST(Nearest, AnglesAreAsFarApartAsAllPairsSay) {
  Random random(5);
  for (int i = 0; i < 200; ++i) {
    std::vector<double> angles;
    for (uint64_t k = 0; k < random.below(12); ++k) {
      const double special = random.pick(std::vector<double>{-180, 180, 0, 190, -170, 360, 90});
      angles.push_back(random.chance(0.4) ? special : random.uniform(-200, 200));
    }
    const std::vector<double> nearest = nearestOnCircle(angles);
    ASSERT_EQ(nearest.size(), angles.size());
    for (size_t k = 0; k < angles.size(); ++k) {
      EXPECT_NEAR(std::min(nearest[k], 999.0), std::min(bruteOnCircle(angles[k], angles), 999.0),
                  1e-12)
          << i;
    }
  }
}

/// States that steer to these places, one each.
std::string steering(const std::vector<Position>& places) {
  std::string text =
      "glider_ir 1\nmission m platform slocum\n"
      "behaviour profile level symbol \"\" () reads ()\n"
      "behaviour route nav symbol \"\" () reads ()\n";
  for (size_t i = 0; i < places.size(); ++i) {
    const std::string next = i + 1 == places.size() ? "exit" : fmt::format("goto s{}", i + 1);
    text += fmt::format(
        "state s{} route nav begin entry do steer_to ({}:latitude, {}:longitude) end end\n"
        "profile level begin entry do surface () end end case (ge statetime 60:time) {}\n",
        i, places[i].latitude, places[i].longitude, next);
  }
  return text;
}

using Told = std::multimap<uint32_t, std::string>;

/// A position whose latitude and longitude are exchanged is reported as that, not as far off.
struct Found {
  Told far_off;
  std::vector<support::SourceRange> exchanged;  ///< each with its numbers
};

Found foundIn(const Mission& mission) {
  support::DiagnosticEngine diagnostics;
  const MissionFacts facts = verify(mission, diagnostics);
  (void)prove(mission, facts, slocum(), {}, diagnostics);
  Found found;
  for (const auto& diagnostic : diagnostics.sorted()) {
    if (diagnostic.id == support::diagnostics::waypointFarOff) {
      found.far_off.emplace(diagnostic.range.begin, diagnostic.message);
    } else if (diagnostic.id == support::diagnostics::positionSwapped) {
      found.exchanged.push_back(diagnostic.range);
    }
  }
  return found;
}

/// The same by comparing all pairs: places first, then latitudes and longitudes by themselves.
Told byAllPairs(const Mission& m) {
  constexpr double kFarOff = 3e6;
  Told told;
  std::set<uint32_t> halves;  // of places that are reported as a whole
  const auto tell = [&](const support::SourceRange& range, double nearest) {
    const bool far = std::isfinite(nearest) && nearest > kFarOff;
    if (far && !told.contains(range.begin) && !halves.contains(range.begin)) {
      told.emplace(range.begin,
                   fmt::format("this position is {:.0f} km from the other positions of the mission",
                               nearest / 1000));
    }
    return far;
  };
  std::vector<Position> places;
  for (const State& state : m.states) {
    places.push_back(*fixedTarget(m, *commandsOf(m, state.route).front()));
  }
  for (size_t i = 0; i < places.size(); ++i) {
    if (tell(m.states[i].route.range, bruteNearest(places[i], places))) {
      for (const ExprId half : commandsOf(m, m.states[i].route).front()->values) {
        halves.insert(m[half].range.begin);
      }
    }
  }
  for (const TypeKind kind : {TypeKind::Latitude, TypeKind::Longitude}) {
    std::vector<double> degrees;
    std::vector<double> latitudes;
    std::vector<support::SourceRange> ranges;
    for (const Expr& e : m.exprs) {
      if (e.op == Op::Constant && e.type.kind == kind) {
        degrees.push_back(e.number);
        ranges.push_back(e.range);
      }
      if (e.op == Op::Constant && e.type.kind == TypeKind::Latitude) {
        latitudes.push_back(e.number);
      }
    }
    std::ranges::sort(latitudes);
    const double middle = latitudes[latitudes.size() / 2] * std::numbers::pi / 180;
    const double metres = kMetresPerDegree * (kind == TypeKind::Longitude ? std::cos(middle) : 1);
    for (size_t i = 0; i < degrees.size(); ++i) {
      tell(ranges[i], bruteOnCircle(degrees[i], degrees) * metres);
    }
  }
  return told;
}

TEST(Nearest, MissionsGetWhatAllPairsGive) {
  Random random(11);
  size_t told = 0;
  for (int i = 0; i < 60; ++i) {
    std::vector<Position> places;
    for (uint64_t k = 0; k < 2 + random.below(7); ++k) {
      const Position place = anyPlace(random, places);
      places.push_back({place.latitude, std::remainder(place.longitude, 360)});
    }
    const Mission mission = missionOf(steering(places));
    const Found found = foundIn(mission);
    Told expected = byAllPairs(mission);
    std::erase_if(expected, [&](const auto& one) {
      return std::ranges::any_of(found.exchanged, [&](const support::SourceRange& range) {
        return range.begin <= one.first && one.first < range.end;
      });
    });
    EXPECT_EQ(found.far_off, expected) << i;
    told += found.far_off.size();
  }
  EXPECT_GT(told, 40U);
}

/// Ten times the places take some ten times as long, not a hundred: here with much to spare.
TEST(Nearest, TenTimesThePlacesDoNotTakeAHundredTimesAsLong) {
  const auto secondsOf = [](int count) {
    Random random(1);
    std::vector<Position> places;
    std::vector<double> angles;
    for (int i = 0; i < count; ++i) {
      places.push_back({39, random.uniform(-75, -70)});
      angles.push_back(places.back().longitude);
    }
    const auto begin = std::chrono::steady_clock::now();
    const PlaceIndex index(places);
    double sum = nearestOnCircle(angles).front();
    for (const Position& place : places) {
      sum += index.nearestOther(place);
    }
    EXPECT_GT(sum, 0);
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  };
  double ratio = kInfinite;
  for (int i = 0; i < 5; ++i) {
    ratio = std::min(ratio, secondsOf(20000) / secondsOf(2000));
  }
  EXPECT_LT(ratio, 40);
}

}  // namespace
}  // namespace glider::ir::prove
