// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What sema makes of operators, positions, windows and areas, in the IR that it writes.

#include "ir/core/mission.h"
#include "support/diagnostics/ids/meaning.h"
#include "tests/unit/frontend/compile.h"

#include <fmt/format.h>

namespace glider::frontend {
namespace {

using testing_support::FrontendRun;

std::string withCase(const std::string& guard, const std::string& above = "") {
  return "mission t\n" + above + "state s\nbegin\n  flightprofile yo(5 m, 20 m, 26 deg, 26 deg)\n" +
         "  sensors depth, temp, lat, lon, missiontime, heading\n  events\n    case " + guard +
         " exit\nend\n";
}

/// The guard of the mission's one case; what was said where there is none.
struct Guard {
  explicit Guard(const std::string& guard, const std::string& above = "")
      : run(withCase(guard, above)), mission(run.compile()) {}
  [[nodiscard]] const ir::Expr& expr() const {
    return (*mission)[mission->states.at(0).cases.at(0).guard];
  }
  [[nodiscard]] const ir::Expr& operand(size_t i) const {
    return (*mission)[expr().operands.at(i)];
  }

  FrontendRun run;
  std::optional<ir::Mission> mission;
};

TEST(Operators, EachComparisonHasItsOperation) {
  const std::pair<const char*, ir::Op> comparisons[] = {
      {"<", ir::Op::Less},          {"<=", ir::Op::LessEqual}, {">", ir::Op::Greater},
      {">=", ir::Op::GreaterEqual}, {"==", ir::Op::Equal},     {"!=", ir::Op::NotEqual}};
  for (const auto& [text, op] : comparisons) {
    const Guard g(fmt::format("depth {} 7 m", text));
    ASSERT_TRUE(g.mission) << g.run.said();
    EXPECT_EQ(g.expr().op, op) << text;
    EXPECT_EQ(g.operand(0).op, ir::Op::Sensor) << text;
    EXPECT_EQ(g.operand(1).number, 7) << text;
  }
  const std::pair<const char*, ir::Op> arithmetic[] = {
      {"+", ir::Op::Add}, {"-", ir::Op::Subtract}, {"*", ir::Op::Multiply}, {"/", ir::Op::Divide}};
  for (const auto& [text, op] : arithmetic) {
    const bool product = op == ir::Op::Multiply || op == ir::Op::Divide;
    const Guard g(fmt::format("depth {} {} > 7 m", text, product ? "3" : "3 m"));
    ASSERT_TRUE(g.mission) << g.run.said();
    EXPECT_EQ(g.operand(0).op, op) << text;
  }
  for (const auto& [text, op] : {std::pair{"&&", ir::Op::And}, {"||", ir::Op::Or}}) {
    const Guard g(fmt::format("depth > 7 m {} temp < 3 degC", text));
    ASSERT_TRUE(g.mission) << g.run.said();
    EXPECT_EQ(g.expr().op, op);
    EXPECT_EQ(g.operand(0).op, ir::Op::Greater) << "left";
    EXPECT_EQ(g.operand(1).op, ir::Op::Less) << "right";
  }
}

TEST(Operators, BareNumbersTakeTheUnitOfTheOtherSide) {
  for (const char* guard : {"depth > 7", "7 < depth", "depth + 2 > 9 - 2 + 2", "depth > 3 + 4"}) {
    const Guard g(guard);
    EXPECT_TRUE(g.mission) << guard << "\n" << g.run.said();
  }
  const Guard minutes("missiontime > 90");
  ASSERT_TRUE(minutes.mission);
  EXPECT_EQ(minutes.operand(1).number, 90);
  EXPECT_FALSE(Guard("depth > temp").mission);
  EXPECT_FALSE(Guard("depth > 7 degC").mission);
  EXPECT_FALSE(Guard("depth && temp > 3 degC").mission) << "a length is not a condition";
}

TEST(Positions, LettersAndCommasSayTheSamePlace) {
  const auto place = [](const std::string& position) {
    FrontendRun run("mission t\nstate s\nbegin\n  flightroute nav(" + position +
                    ")\n  flightprofile yo(5 m, 20 m, 26 deg, 26 deg)\n  sensors missiontime\n"
                    "  events\n    case missiontime > 20 min exit\nend\n");
    const auto mission = run.compile();
    EXPECT_TRUE(mission) << position << "\n" << run.said();
    std::pair<double, double> found{0, 0};
    if (mission) {
      for (const ir::Expr& e : mission->exprs) {
        if (e.op == ir::Op::Constant && e.type.kind == ir::TypeKind::Latitude) {
          found.first = e.number;
        }
        if (e.op == ir::Op::Constant && e.type.kind == ir::TypeKind::Longitude) {
          found.second = e.number;
        }
      }
    }
    return found;
  };
  using Place = std::pair<double, double>;
  EXPECT_EQ(place("39.2 N, 73.9 W"), (Place{39.2, -73.9}));
  EXPECT_EQ(place("39.2 N 73.9 W"), (Place{39.2, -73.9}));
  EXPECT_EQ(place("39.2 S 73.9 E"), (Place{-39.2, 73.9}));
}

TEST(Windows, RunAlongQuantitiesOnly) {
  for (const char* good : {"mean(temp, 5 m of depth) > 3 degC", "mean(temp, 60 s) > 3 degC",
                           "spread(temp, 2 degC of temp) > 1 degC"}) {
    const Guard g(good);
    EXPECT_TRUE(g.mission) << good << "\n" << g.run.said();
  }
  for (const char* bad : {"mean(temp, 1 deg of lat) > 3 degC", "mean(temp, 1 deg of lon) > 3 degC",
                          "mean(temp, 5 of nothing) > 3 degC"}) {
    const Guard g(bad);
    EXPECT_FALSE(g.mission) << bad;
    EXPECT_TRUE(g.run.says(support::diagnostics::stretchOfWhat)) << bad << "\n" << g.run.said();
  }
}

/// What a requirement makes of the geofences of its condition.
std::string geofences(const std::string& promise) {
  const Guard g("missiontime > 20 min", "require always " + promise + "\n");
  EXPECT_TRUE(g.mission) << promise << "\n" << g.run.said();
  std::string found;
  if (g.mission) {
    for (const auto& fence : g.mission->requirements.at(0).geofences) {
      found += fence.keep_in ? "in " : "out ";
      found += fence.isDisc()
                   ? fmt::format("{:g} m of {:g} {:g} ", fence.radius_m,
                                 fence.corners.at(0).latitude, fence.corners.at(0).longitude)
                   : "";
    }
  }
  return found;
}

TEST(Areas, OnlyWhatMustHoldTogetherIsGathered) {
  const std::string here = "inside(39 N 74 W, 39 N 73 W, 40 N 73.5 W)";
  const std::string there = "inside(39.2 N 73.6 W, 39.2 N 73.4 W, 39.4 N 73.5 W)";
  EXPECT_EQ(geofences(here), "in ");
  EXPECT_EQ(geofences("!" + there), "out ");
  EXPECT_EQ(geofences(here + " && !" + there), "in out ");
  EXPECT_EQ(geofences(here + " || !" + there), "") << "either may be left";
  EXPECT_EQ(geofences("!(!" + here + " || " + there + ")"), "in out ");
  EXPECT_EQ(geofences("!(" + here + " && " + there + ")"), "");
  EXPECT_EQ(geofences(here + " && depth < 30 m"), "") << "there is more to it";
}

TEST(Areas, ADistanceToAPlaceIsADisc) {
  const std::string here = "distance(39 N 74 W)";
  const std::string in = "in 3000 m of 39 -74 ";
  const std::string out = "out 3000 m of 39 -74 ";
  for (const char* closer :
       {"distance(39 N 74 W) < 3 km", "distance(39 N 74 W) <= 3 km", "3 km > distance(39 N 74 W)",
        "3000 m >= distance(39 N 74 W)", "!(distance(39 N 74 W) > 3 km)",
        "!(3 km <= distance(39 N 74 W))", "distance(lat, lon, 39 N 74 W) < 3 km",
        "distance(39 N 74 W, lat, lon) < 1 km + 2 km"}) {
    EXPECT_EQ(geofences(closer), in) << closer;
  }
  EXPECT_EQ(geofences(here + " > 3 km"), out);
  EXPECT_EQ(geofences("3 km <= " + here), out);
  EXPECT_EQ(geofences("!(" + here + " < 3 km)"), out);
  EXPECT_EQ(geofences(here + " < 3 km && !(" + here +
                      " <= 3 km || inside(39 N 74 W, 39 N 73 W, "
                      "40 N 73.5 W))"),
            in + out + "out ");
  for (const char* other :
       {"distance(39 N 74 W) < 3 km || depth < 30 m", "distance(39 N 74 W) < 3 km && depth < 30 m",
        "distance(39 N 74 W) < depth * 100", "distance(gpslat, gpslon, 39 N 74 W) < 3 km",
        "distance(39 N 74 W, 39 N 73 W) > 3 km", "distance(lat, lon, lat, lon) < 3 km",
        "distance(39 N 74 W) >= 0 m", "distance(39 N 74 W) < 20100 km"}) {
    EXPECT_EQ(geofences(other), "") << other;
  }
}

}  // namespace
}  // namespace glider::frontend
