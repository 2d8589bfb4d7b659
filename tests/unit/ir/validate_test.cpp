// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/core/validate.h"

#include "tests/unit/ir/missions.h"

#include <functional>
#include <limits>

namespace glider::ir {
namespace {

Mission sound() {
  return missionOf(
      kHeader +
      "state a route drift () profile to ((sensor depth), 5:time) log depth every 8 (sensor depth) "
      "case (lt (sensor depth) 5:length) goto a case true exit");
}

TEST(Validate, AcceptsASoundMission) {
  EXPECT_TRUE(validate(sound()).empty());
}

struct Damage {
  const char* name;
  std::function<void(Mission&)> make;
};

class ValidateDamaged : public testing::TestWithParam<Damage> {};

TEST_P(ValidateDamaged, IsFound) {
  Mission m = sound();
  GetParam().make(m);
  EXPECT_FALSE(validate(m).empty());
}

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr ExprId kFirst{0};
Expr& less(Mission& m) {
  return m.exprs[m.states[0].cases[0].guard.index];
}

const Damage kDamages[] = {
    {"noState", [](Mission& m) { m.states.clear(); }},
    {"twoStatesOfOneName", [](Mission& m) { m.states.push_back(m.states[0]); }},
    {"twoSensorsOfOneName", [](Mission& m) { m.sensors[1].name = m.sensors[0].name; }},
    {"twoSensorsOfOneNumber", [](Mission& m) { m.sensors[1].id = m.sensors[0].id; }},
    {"sensorOfBool", [](Mission& m) { m.sensors[1].type = {TypeKind::Bool, {}}; }},
    {"minutesOfNoPosition", [](Mission& m) { m.sensors[1].encoding = Encoding::DegreesMinutes; }},
    {"rangeTurnedRound", [](Mission& m) { m.sensors[1].lowest = 1e9; }},
    {"rangeNaN", [](Mission& m) { m.sensors[1].highest = kNaN; }},
    {"factorZero", [](Mission& m) { m.sensors[1].to_si = 0; }},
    {"staleNaN", [](Mission& m) { m.sensors[1].stale_after_s = kNaN; }},
    {"positionWithDimension",
     [](Mission& m) { m.sensors[1].type = {TypeKind::Latitude, support::dimension::length}; }},
    {"behavioursOfOneName", [](Mission& m) { m.behaviours[1].name = m.behaviours[0].name; }},
    {"behaviourReadsNothing", [](Mission& m) { m.behaviours[0].reads = {{9}}; }},
    {"operandMissing", [](Mission& m) { less(m).operands[1] = {}; }},
    {"operandTooMany", [](Mission& m) { less(m).operands[2] = kFirst; }},
    {"operandLater", [](Mission& m) { less(m).operands[0] = m.states[0].cases[1].guard; }},
    {"operandItself", [](Mission& m) { less(m).operands[0] = m.states[0].cases[0].guard; }},
    {"sensorMissing", [](Mission& m) { m.exprs[0].sensor = {}; }},
    {"sensorOutOfRange", [](Mission& m) { m.exprs[0].sensor = {2}; }},
    {"sensorOfComparison", [](Mission& m) { less(m).sensor = {0}; }},
    {"typeWrong", [](Mission& m) { less(m).type = {}; }},
    {"operandsOfTwoTypes", [](Mission& m) { less(m).operands[1] = {1}; }},
    {"opOutOfRange", [](Mission& m) { less(m).op = static_cast<Op>(200); }},
    {"constantNaN", [](Mission& m) { m.exprs[1].number = kNaN; }},
    {"numberOnComparison", [](Mission& m) { less(m).number = 1; }},
    {"guardOfNumber", [](Mission& m) { m.states[0].cases[0].guard = kFirst; }},
    {"guardMissing", [](Mission& m) { m.states[0].cases[0].guard = {}; }},
    {"targetMissing", [](Mission& m) { m.states[0].cases[0].target = {}; }},
    {"targetOutOfRange", [](Mission& m) { m.states[0].cases[0].target = {1}; }},
    {"targetOfExit", [](Mission& m) { m.states[0].cases[1].target = {0}; }},
    {"logOfTruth", [](Mission& m) { m.states[0].log[0].value = m.states[0].cases[0].guard; }},
    {"logBackwards", [](Mission& m) { m.states[0].log[0].period_s = -1; }},
    {"noProfile", [](Mission& m) { m.states[0].profile.behaviour = {}; }},
    {"routeForProfile", [](Mission& m) { m.states[0].profile = m.states[0].route; }},
    {"argumentMissing", [](Mission& m) { m.states[0].profile.arguments.pop_back(); }},
    {"argumentOfOtherType", [](Mission& m) { m.states[0].profile.arguments[1] = kFirst; }},
    {"argumentOutOfRange", [](Mission& m) { m.states[0].profile.arguments[1] = {99}; }},
};

INSTANTIATE_TEST_SUITE_P(Damages, ValidateDamaged, testing::ValuesIn(kDamages),
                         [](const auto& damage) { return damage.param.name; });

}  // namespace
}  // namespace glider::ir
