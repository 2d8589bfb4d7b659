// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What places and paths mean, by the values of the guards that they are lowered to.

#include "ir/eval/arithmetic.h"
#include "ir/eval/evaluate.h"
#include "runtime/abi/glider_abi.h"
#include "tests/unit/frontend/compile.h"

#include <fmt/format.h>

#include <cmath>
#include <random>
#include <span>

namespace glider::frontend {
namespace {

using testing_support::FrontendRun;

/// A mission with one guard to ask.
class PlaceGuard {
 public:
  explicit PlaceGuard(const std::string& guard)
      : run_(fmt::format(
            "mission m\nconst area = [39 N 74 W, 39 N 73 W, 40 N 73.5 W]\n"
            "var next : number = 0 in -5 .. 5\n"
            "state s\nbegin\n flightprofile surfaced\n sensors missiontime, lat, lon\n"
            "events\n case {} exit\n"
            " case missiontime > 1 h do set next = clamp(next + 1, 0, 5) end stay\nend\n",
            guard)),
        mission_(run_.compile()) {
    EXPECT_TRUE(mission_.has_value()) << run_.said();
  }

  /// The guard's truth at a place, with `next` as it is.
  ir::Truth at(double north, double east, double next = 0) const {
    const auto leaf = [&](const ir::Expr& expr, std::span<const double>) -> ir::Value {
      if (expr.op == ir::Op::Sensor) {
        return expr.type.kind == ir::TypeKind::Latitude ? north : east;
      }
      return expr.op == ir::Op::Variable ? next : 0.0;
    };
    const auto value = ir::evaluate(*mission_, mission_->states.front().cases.front().guard, leaf);
    return std::get<ir::Truth>(value);
  }

 private:
  FrontendRun run_;
  std::optional<ir::Mission> mission_;
};

constexpr auto kTrue = ir::Truth::True;
constexpr auto kFalse = ir::Truth::False;
constexpr auto kUnsure = ir::Truth::Unknown;

TEST(Places, InsideATriangle) {
  const PlaceGuard guard("inside(area)");
  EXPECT_EQ(guard.at(39.5, -73.5), kTrue);
  EXPECT_EQ(guard.at(39.001, -73.9), kTrue);
  EXPECT_EQ(guard.at(39.5, -73.9), kFalse);
  EXPECT_EQ(guard.at(38.9, -73.5), kFalse);
  EXPECT_EQ(guard.at(40.1, -73.5), kFalse);
  EXPECT_EQ(guard.at(39.5, 106.5), kFalse);  // the other side of the Earth
}

TEST(Places, InsideIsUnknownWithoutAPosition) {
  const PlaceGuard guard("inside(area)");
  EXPECT_EQ(guard.at(ir::kUnknown, -73.5), kUnsure);
  EXPECT_EQ(guard.at(39.5, ir::kUnknown), kUnsure);
  EXPECT_EQ(guard.at(45, ir::kUnknown), kFalse);  // outside at any longitude
}

TEST(Places, InsideAcrossTheAntimeridianEitherWayRound) {
  for (const char* corners : {"10 S 179 E, 10 S 179 W, 12 S 179 W, 12 S 179 E",
                              "10 S 179 W, 12 S 179 W, 12 S 179 E, 10 S 179 E"}) {
    const PlaceGuard guard(fmt::format("inside({})", corners));
    EXPECT_EQ(guard.at(-11, 179.5), kTrue) << corners;
    EXPECT_EQ(guard.at(-11, 180), kTrue) << corners;
    EXPECT_EQ(guard.at(-11, -180), kTrue) << corners;
    EXPECT_EQ(guard.at(-11, -179.5), kTrue) << corners;
    EXPECT_EQ(guard.at(-11, -178.5), kFalse) << corners;
    EXPECT_EQ(guard.at(-11, 178.5), kFalse) << corners;
    EXPECT_EQ(guard.at(-11, 0), kFalse) << corners;
  }
}

/// The sum of the angles under which the edges are seen: an independent reference.
bool wound(const std::vector<std::pair<double, double>>& corners, double north, double east) {
  double sum = 0;
  for (size_t i = 0; i < corners.size(); ++i) {
    const auto& [an, ae] = corners[i];
    const auto& [bn, be] = corners[(i + 1) % corners.size()];
    const double cross = (ae - east) * (bn - north) - (an - north) * (be - east);
    const double dot = (ae - east) * (be - east) + (an - north) * (bn - north);
    sum += std::atan2(cross, dot);
  }
  return std::lround(sum / (2 * M_PI)) % 2 != 0;
}

TEST(Places, InsideAgreesWithTheWindingNumber) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> north(38, 41);
  std::uniform_real_distribution<double> east(-75, -72);
  for (int polygon = 0; polygon < 20; ++polygon) {
    std::vector<std::pair<double, double>> corners;
    std::string text;
    for (int i = 0; i < 3 + polygon % 5; ++i) {
      corners.emplace_back(north(random), east(random));
      text += fmt::format("{}{} N {} W", text.empty() ? "" : ", ", corners.back().first,
                          -corners.back().second);
    }
    const PlaceGuard guard("inside(" + text + ")");
    // A moving first corner makes the general form of the same area.
    const PlaceGuard moving(fmt::format("inside(clamp(lat, {0} N, {0} N), {1} W{2})",
                                        corners[0].first, -corners[0].second,
                                        text.substr(text.find(','))));
    for (int i = 0; i < 200; ++i) {
      const double n = north(random);
      const double e = east(random);
      const ir::Truth expected = wound(corners, n, e) ? kTrue : kFalse;
      EXPECT_EQ(guard.at(n, e), expected) << text << " at " << n << " " << e;
      EXPECT_EQ(moving.at(n, e), expected) << text << " at " << n << " " << e;
    }
  }
}

TEST(Places, APathIsIndexedFromZeroAndUnknownBeyond) {
  const PlaceGuard guard("distance(area[next], 39 N 73 W) < 1 m");
  EXPECT_EQ(guard.at(0, 0, 0), kFalse);
  EXPECT_EQ(guard.at(0, 0, 1), kTrue);
  EXPECT_EQ(guard.at(0, 0, 2), kFalse);
  for (const double none : {-1.0, 3.0, 0.5, ir::kUnknown}) {
    EXPECT_EQ(guard.at(0, 0, none), kUnsure) << none;
  }
  EXPECT_EQ(PlaceGuard("distance(area[1], 39 N 73 W) < 1 m").at(0, 0), kTrue);
}

TEST(Places, DistanceAndBearingAreFromHere) {
  const double metres = gliderDistance(39.5, -73.5, 40, -73.5);
  const PlaceGuard far(fmt::format("distance(area[2]) > {} m", metres));
  EXPECT_EQ(far.at(39.5, -73.5), kFalse);
  EXPECT_EQ(far.at(39.49, -73.5), kTrue);
  EXPECT_EQ(PlaceGuard("bearing(area[2]) < 1 deg").at(39.5, -73.5), kTrue);
  EXPECT_EQ(PlaceGuard("bearing(area[2]) < 1 deg").at(40, -73.5), kUnsure);  // here it is
}

}  // namespace
}  // namespace glider::frontend
