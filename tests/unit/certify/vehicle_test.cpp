// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The environment model, rule by rule: what a vehicle may do, and just not.

#include "ir/certify/vehicle.h"

#include "tests/unit/certify/judge.h"
#include "tests/unit/ir/slocum.h"

#include <fmt/format.h>

namespace glider::ir::certify {
namespace {

class VehicleRules : public testing::Test {
 protected:
  void SetUp() override { NEEDS_CVC5(); }

  static Vehicle at(double depth, double deepest) {
    return {literal(depth), literal(deepest), "false", "0.0", "0.0"};
  }
  static Vehicle climbing(double depth, double deepest, double since, double top) {
    return {literal(depth), literal(deepest), "true", literal(since), literal(top)};
  }
  Vehicle after(const Vehicle& v, Command command, double x, double now = 100) {
    return commanded(setting_, out_, v, command,
                     std::vector<Number>{{literal(x), "true"}, {"0.4", "true"}}, literal(now));
  }
  Vehicle later(const Vehicle& v, double from, double to) {
    return vehicleLater(setting_, out_, v, literal(from), literal(to));
  }
  bool can(const Term& term) {
    const auto answers =
        answersTo("(set-logic ALL)\n" + out_.text() + "(assert " + term + ")\n(check-sat)\n");
    EXPECT_EQ(answers.size(), 1u);
    EXPECT_TRUE(answers.at(0) == "sat" || answers.at(0) == "unsat") << answers.at(0);
    return answers.at(0) == "sat";
  }
  bool is(const Term& a, double b) { return !can(fmt::format("(not (= {} {}))", a, literal(b))); }
  bool isTrue(const Term& a) { return !can(fmt::format("(not {})", a)); }
  bool reaches(const Vehicle& v, double depth) {
    return can(fmt::format("(= {} {})", v.depth, literal(depth)));
  }

  Mission mission_;
  Requirement requirement_;
  Facts facts_;
  Setting setting_{mission_, slocum(), requirement_, facts_};
  SmtText out_;
};

TEST_F(VehicleRules, V1TheStart) {
  const Vehicle v = vehicleAtStart(setting_, out_);
  EXPECT_TRUE(reaches(v, 0) && reaches(v, 3));
  EXPECT_FALSE(reaches(v, 3.001) || reaches(v, -0.001));
  EXPECT_FALSE(can(fmt::format("(not (= {} (+ {} 5.0)))", v.deepest, v.depth)));
  EXPECT_EQ(v.climbing, "false");
}

TEST_F(VehicleRules, V2NoFasterThanItsRate) {
  const Vehicle v = later(at(10, 20), 50, 60);
  EXPECT_TRUE(reaches(v, 6.001) && reaches(v, 13.999));
  EXPECT_FALSE(reaches(v, 14.001) || reaches(v, 5.999));
}

TEST_F(VehicleRules, V2BetweenTheSurfaceAndItsDeepest) {
  const Vehicle v = later(at(10, 20), 50, 350);
  EXPECT_TRUE(reaches(v, 0) && reaches(v, 20));
  EXPECT_FALSE(reaches(v, 20.001) || reaches(v, -0.001));
}

TEST_F(VehicleRules, V2AClimbFromTurnOn) {
  // 120 s after 100 s it climbs at 0.05 m/s from its deepest.
  EXPECT_TRUE(reaches(later(climbing(20, 20, 100, 5), 200, 219), 20));
  EXPECT_TRUE(reaches(later(climbing(20, 20, 100, 5), 200, 240), 18.999));
  EXPECT_FALSE(reaches(later(climbing(20, 20, 100, 5), 200, 240), 19.001));
  EXPECT_TRUE(reaches(later(climbing(20, 20, 100, 5), 200, 1000), 5)) << "it may stop at the top";
  EXPECT_FALSE(reaches(later(climbing(20, 20, 100, 5), 200, 1000), 5.001));
  EXPECT_FALSE(reaches(later(climbing(1, 20, 100, 0), 900, 1000), 0.001));
  EXPECT_TRUE(reaches(later(at(20, 20), 200, 1000), 20)) << "no climb is in force";
}

TEST_F(VehicleRules, V3ToDescendOrHover) {
  for (const Command command : {Command::Descend, Command::Hover}) {
    const Vehicle v = after(climbing(10, 30, 50, 5), command, 20);
    EXPECT_TRUE(is(v.deepest, 25));
    EXPECT_EQ(v.climbing, "false");
    EXPECT_TRUE(is(after(at(10, 30), command, 3).deepest, 24.6))
        << "the dive before ends within 5 m, and what it sinks in 24 s: it may have to wait";
    EXPECT_TRUE(is(after(at(10, 12), command, 3).deepest, 12));
    EXPECT_TRUE(is(after(at(10, 12), command, 9).deepest, 14));
  }
}

TEST_F(VehicleRules, V4ToAscend) {
  const Vehicle v = after(at(10, 30), Command::Ascend, 4);
  EXPECT_TRUE(is(v.top, 9) && is(v.deepest, 24.6) && is(v.since, 100) && isTrue(v.climbing));
  EXPECT_TRUE(is(after(at(1, 6), Command::Ascend, 4).deepest, 9)) << "it may sink to the top";
  const Vehicle surface = after(at(10, 12), Command::Surface, 0);
  EXPECT_TRUE(is(surface.top, 0) && is(surface.deepest, 12) && isTrue(surface.climbing));
  EXPECT_TRUE(is(after(at(10, 30), Command::Ascend, 0.9).top, 0.9));
  EXPECT_TRUE(is(after(at(10, 30), Command::Ascend, 1).top, 6));
}

TEST_F(VehicleRules, V4AClimbGoesOn) {
  const Vehicle same = after(climbing(10, 30, 50, 9), Command::Ascend, 4);
  EXPECT_TRUE(is(same.since, 50) && is(same.deepest, 30) && is(same.top, 9));
  const Vehicle higher = after(climbing(10, 30, 50, 9), Command::Ascend, 3);
  EXPECT_TRUE(is(higher.since, 100) && is(higher.deepest, 24.6) && is(higher.top, 8));
  const Vehicle lower = after(climbing(10, 30, 50, 9), Command::Ascend, 6);
  EXPECT_TRUE(is(lower.since, 50) && is(lower.top, 11));
}

TEST_F(VehicleRules, V5UnknownArgumentsAndSteering) {
  for (const Command command : {Command::Descend, Command::Ascend}) {
    const std::vector<Number> unknown{{"20.0", "true"}, {"0.4", "false"}};
    const Vehicle v = commanded(setting_, out_, climbing(10, 30, 50, 9), command, unknown, "100.0");
    EXPECT_TRUE(is(v.deepest, 30) && is(v.since, 50) && is(v.top, 9) && isTrue(v.climbing));
  }
  EXPECT_TRUE(is(after(at(10, 30), Command::Steer, 2).deepest, 30));
  EXPECT_TRUE(is(after(at(10, 30), Command::Fin, 0.2).deepest, 30));
}

TEST_F(VehicleRules, V8PumpAndBatteryLeadAsDeepAsTheHullAllows) {
  for (const Command command : {Command::Pump, Command::Battery}) {
    const Vehicle v = after(climbing(10, 30, 50, 5), command, 0.0001);
    EXPECT_TRUE(is(v.deepest, 205));
    EXPECT_EQ(v.climbing, "false");
    const Term end = after(at(300, 500), command, -1).deepest;  // 5 m, and 0.4 m/s for 24 s
    EXPECT_FALSE(can(fmt::format("(or (< {0} 314.599) (> {0} 314.601))", end)))
        << "where the dive before ends";
    const std::vector<Number> unknown{{"0.0", "false"}};
    const Vehicle same =
        commanded(setting_, out_, climbing(10, 30, 50, 9), command, unknown, "100.0");
    EXPECT_TRUE(is(same.deepest, 30) && isTrue(same.climbing)) << "an unknown one";
  }
}

TEST_F(VehicleRules, V6CodeInCMayCommandAnything) {
  const Vehicle v = commandedInC(out_, climbing(10, 30, 50, 9));
  EXPECT_TRUE(can(fmt::format("(and (= {} 500.0) (not {}))", v.deepest, v.climbing)));
  EXPECT_TRUE(can(fmt::format("(and (= {} 10.0) {} (= {} 0.0))", v.deepest, v.climbing, v.top)));
  EXPECT_FALSE(can(fmt::format("(< {} 10.0)", v.deepest)));
  EXPECT_EQ(v.depth, "10.0");
}

}  // namespace
}  // namespace glider::ir::certify
