// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/core/validate.h"

#include "ir/core/share_messages.h"
#include "tests/unit/ir/missions.h"

#include <array>
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

/// A mission with one of everything. Variables: p, m, t (argument of b), s (state b's), d (profile
/// b's). Blocks: 0 and 1 nested in 2 (of `always`), 3 (profile b's), 4 (entry of b).
Mission whole() {
  return missionOf(kHeader + R"(behaviour profile yo symbol "" () reads ()
variable p: length parameter lowest 1 highest 9
variable m: length mission
variable t: length argument of b
variable s: bool state of b
variable d: bool profile of b
table length (3, 4)
initial p 5:length initial m (var p) condition (gt (var p) 2:length)
temporal held always (lt (sensor depth) 4:length) for 8:time
temporal mean state b (sensor depth) over 60 along (sensor temp)
always case (temporal 0) do if true set m 1:length else set m (element 0 1) end end goto b ((var m))
state a route drift () profile glide () case true call b ((sensor depth))
state b (t) initial s false initial d (var s) route drift ()
  profile yo done d begin case (var d) do surface () end done end
  entry do set s true end
  case (gt (temporal 1) (var t)) return
)");
}

TEST(Validate, AcceptsASoundMission) {
  EXPECT_TRUE(validate(sound()).empty());
  EXPECT_TRUE(validate(whole()).empty());
}

TEST(Validate, ANapHasALength) {
  for (const double good : {0.5, 240.0}) {
    Mission m = sound();
    m.nap_s = good;
    EXPECT_TRUE(validate(m).empty()) << good;
  }
  constexpr double kEndless = std::numeric_limits<double>::infinity();
  for (const double wrong : {0.0, -1.0, kEndless, std::numeric_limits<double>::quiet_NaN()}) {
    Mission m = sound();
    m.nap_s = wrong;
    EXPECT_EQ(validate(m).size(), 1U) << wrong;
  }
}

/// Only a parameter that is a plain number counts something.
TEST(Validate, TheUnitOfAVariable) {
  const auto valid = [](const std::string& variable, const std::string& initial,
                        const std::string& unit) {
    Mission m = missionOf(kHeader + "variable v: " + variable + " initial v " + initial +
                          " state a route drift () profile glide () case true exit");
    m.variables[0].unit = unit;
    return validate(m).empty();
  };
  EXPECT_TRUE(valid("number parameter", "1", "uM"));
  EXPECT_TRUE(valid("number parameter", "1", "ug/L"));
  EXPECT_FALSE(valid("number parameter", "1", "m"));
  EXPECT_FALSE(valid("number parameter", "1", "mol"));
  EXPECT_FALSE(valid("number mission", "1", "uM"));
  EXPECT_FALSE(valid("length parameter", "1:length", "uM"));
  EXPECT_FALSE(valid("length parameter", "1:length", "m"));
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

constexpr double kInvalidNumber = std::numeric_limits<double>::quiet_NaN();
constexpr ExprId kFirst{0};
constexpr Type kSecond{TypeKind::Quantity, support::dimension::time};
Expr& less(Mission& m) {
  return m.exprs[m.states[0].cases[0].guard.index];
}

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

Sensor heading() {
  return {"heading",
          "m_heading",
          7,
          {TypeKind::Quantity, support::dimension::angle},
          Encoding::Linear,
          1,
          0,
          6.283,
          20};
}

TEST(Validate, AcceptsACompass) {
  Mission m = sound();
  m.sensors.push_back(heading());
  m.compass = {{2}, -3.14};
  EXPECT_TRUE(validate(m).empty());
  m.sensors.back().encoding = Encoding::Magnetic;
  m.compass = Compass{};
  EXPECT_TRUE(validate(m).empty());
}

/// A table of two rows for the first state's cases: sound until a damage is planted in it.
GuardTable& tabled(Mission& m) {
  GuardTable& table = m.states[0].table;
  if (table.empty()) {
    m.states[0].cases.push_back(m.states[0].cases[0]);
    table.columns = {{Op::Sensor, {0}, {{1, true}, {1, false}}}};
    table.rows = {{0, {{0, 3}}, true}, {1, {{1, 1}}, false}};
  }
  return table;
}

const Damage kDamages[] = {
    {"noState", [](Mission& m) { m.states.clear(); }},
    {"twoStatesOfOneName", [](Mission& m) { m.states.push_back(m.states[0]); }},
    {"twoSensorsOfOneName", [](Mission& m) { m.sensors[1].name = m.sensors[0].name; }},
    {"twoSensorsOfOneNumber", [](Mission& m) { m.sensors[1].id = m.sensors[0].id; }},
    {"sensorOfBool", [](Mission& m) { m.sensors[1].type = {TypeKind::Bool, {}}; }},
    {"minutesOfNoPosition", [](Mission& m) { m.sensors[1].encoding = Encoding::DegreesMinutes; }},
    {"magneticTemperature",
     [](Mission& m) {
       m.sensors[1].encoding = Encoding::Magnetic;
       m.compass.emplace();
     }},
    {"magneticWithoutCompass",
     [](Mission& m) {
       m.sensors.push_back(heading());
       m.sensors.back().encoding = Encoding::Magnetic;
     }},
    {"magneticInDegrees",
     [](Mission& m) {
       m.sensors.push_back(heading());
       m.sensors.back().encoding = Encoding::Magnetic;
       m.sensors.back().to_si = 0.0174;
       m.compass.emplace();
     }},
    {"variationOfNoAngle", [](Mission& m) { m.compass = {{1}, {}}; }},
    {"variationMissing", [](Mission& m) { m.compass = {{9}, {}}; }},
    {"declinationTooLarge", [](Mission& m) { m.compass = {{}, 3.2}; }},
    {"declinationNaN", [](Mission& m) { m.compass = {{}, kInvalidNumber}; }},
    {"rangeTurnedRound", [](Mission& m) { m.sensors[1].lowest = 1e9; }},
    {"rangeNaN", [](Mission& m) { m.sensors[1].highest = kInvalidNumber; }},
    {"factorZero", [](Mission& m) { m.sensors[1].to_si = 0; }},
    {"staleNaN", [](Mission& m) { m.sensors[1].stale_after_s = kInvalidNumber; }},
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
    {"constantNaN", [](Mission& m) { m.exprs[1].number = kInvalidNumber; }},
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
    {"tableWithoutColumns", [](Mission& m) { m.states[0].table.rows = {{0, {}, true}}; }},
    {"tableOfNoCase", [](Mission& m) { tabled(m).rows[0].number = 99; }},
    {"tableBackwards", [](Mission& m) { std::swap(tabled(m).rows[0], tabled(m).rows[1]); }},
    {"tableOfNoInterval", [](Mission& m) { tabled(m).rows[0].within[0].last = 4; }},
    {"tableOfMoreColumns", [](Mission& m) { tabled(m).rows[0].within.push_back({}); }},
    {"cutsBackwards",
     [](Mission& m) { std::swap(tabled(m).columns[0].cuts[0], tabled(m).columns[0].cuts[1]); }},
    {"cutNowhere", [](Mission& m) { tabled(m).columns[0].cuts[1].at = kNan; }},
    {"columnOfNoSensor", [](Mission& m) { tabled(m).columns[0].sensor = {77}; }},
    {"columnOfAge", [](Mission& m) { tabled(m).columns[0].source = Op::Age; }},
};

INSTANTIATE_TEST_SUITE_P(Damages, ValidateDamaged, testing::ValuesIn(kDamages),
                         [](const auto& damage) { return damage.param.name; });

class ValidateWholeDamaged : public testing::TestWithParam<Damage> {};

TEST_P(ValidateWholeDamaged, IsFound) {
  Mission m = whole();
  GetParam().make(m);
  EXPECT_FALSE(validate(m).empty());
}

Statement& statement(Mission& m, size_t block) {
  return m.blocks[block].statements[0];
}
Case& doneCase(Mission& m) {
  return m.states[1].profile.cases[0];
}

const Damage kWholeDamages[] = {
    {"twoVariablesOfOneName", [](Mission& m) { m.variables[1].name = "p"; }},
    {"parameterLate", [](Mission& m) { std::swap(m.variables[0].kind, m.variables[1].kind); }},
    {"ownerMissing", [](Mission& m) { m.variables[3].owner = {}; }},
    {"ownerOutOfRange", [](Mission& m) { m.variables[3].owner = {7}; }},
    {"ownerOfMission", [](Mission& m) { m.variables[1].owner = {0}; }},
    {"rangeTurnedRound", [](Mission& m) { m.variables[0].lowest = 10; }},
    {"rangeNaN", [](Mission& m) { m.variables[0].lowest = kInvalidNumber; }},
    {"rangeOfBool", [](Mission& m) { m.variables[3].highest = 1; }},
    {"initialMissing", [](Mission& m) { m.variables[1].initial = {}; }},
    {"initialOfArgument", [](Mission& m) { m.variables[2].initial = m.variables[1].initial; }},
    {"initialOfOtherType", [](Mission& m) { m.variables[1].initial = m.variables[3].initial; }},
    {"initialReadsALaterOne", [](Mission& m) { m.variables[3].initial = doneCase(m).guard; }},
    {"initialOfParameterReads",
     [](Mission& m) { m.variables[0].initial = m.always[0].arguments[0]; }},
    {"conditionReadsASensor", [](Mission& m) { m.conditions[0] = m.temporals[0].operand; }},
    {"conditionIsANumber", [](Mission& m) { m.conditions[0] = m.variables[0].initial; }},
    {"temporalWithoutState", [](Mission& m) { m.temporals[1].state = {}; }},
    {"temporalOfAlwaysWithState", [](Mission& m) { m.temporals[0].state = {0}; }},
    {"temporalWithoutOperand", [](Mission& m) { m.temporals[0].operand = {}; }},
    {"heldWithoutTime", [](Mission& m) { m.temporals[0].duration = {}; }},
    {"heldIsUsedBeforeItsTime", [](Mission& m) { m.temporals[0].duration = {99}; }},
    {"windowOfNoLength", [](Mission& m) { m.temporals[1].length = 0; }},
    {"windowNaN", [](Mission& m) { m.temporals[1].length = kInvalidNumber; }},
    {"windowOfTruth", [](Mission& m) { m.temporals[1].operand = m.temporals[0].operand; }},
    {"legOfALength", [](Mission& m) { m.temporals[1].leg = Leg::This; }},
    {"legWithoutSensor",
     [](Mission& m) {
       m.temporals[1].leg = Leg::Last;
       m.temporals[1].length = 0;
       m.temporals[1].along = {};
     }},
    {"legWithoutEnds",
     [](Mission& m) {
       m.temporals[1].leg = Leg::Last;
       m.temporals[1].length = 0;
       m.temporals[1].dive = kInvalidNumber;
     }},
    {"numberOfALength", [](Mission& m) { m.temporals[1].kind = TemporalKind::Number; }},
    {"comparesNothing", [](Mission& m) { m.temporals[1].kind = TemporalKind::AtLowest; }},
    {"steepestOfNothing", [](Mission& m) { m.temporals[1].kind = TemporalKind::Steepest; }},
    {"windowAlongAVariable", [](Mission& m) { m.temporals[1].along = m.variables[1].initial; }},
    {"tableEmpty", [](Mission& m) { m.tables[0].values.clear(); }},
    {"tableNaN", [](Mission& m) { m.tables[0].values[1] = kInvalidNumber; }},
    {"tableOfTruths", [](Mission& m) { m.tables[0].type = {TypeKind::Bool, {}}; }},
    {"tableOutOfRange", [](Mission& m) { m.exprs[statement(m, 1).value.index].table = {1}; }},
    {"tableOfAnotherType", [](Mission& m) { m.tables[0].type = kSecond; }},
    {"temporalInAnotherState", [](Mission& m) { m.temporals[1].state = {0}; }},
};

const Damage kCodeDamages[] = {
    {"blockUsedTwice", [](Mission& m) { m.states[0].entry = m.states[1].entry; }},
    {"blockUnused", [](Mission& m) { m.states[1].entry = {}; }},
    {"blockOutOfRange", [](Mission& m) { m.states[1].entry = {9}; }},
    {"blockHoldsItself", [](Mission& m) { statement(m, 2).then = {2}; }},
    {"ifWithoutThen", [](Mission& m) { statement(m, 2).then = {}; }},
    {"ifOfANumber", [](Mission& m) { statement(m, 2).value = m.variables[1].initial; }},
    {"setWithBlock", [](Mission& m) { statement(m, 3).then = {0}; }},
    {"setOfAParameter", [](Mission& m) { statement(m, 0).variable = {0}; }},
    {"setOfAnArgument", [](Mission& m) { statement(m, 0).variable = {2}; }},
    {"setOfAnotherState", [](Mission& m) { statement(m, 0).variable = {3}; }},
    {"setOfNothing", [](Mission& m) { statement(m, 0).variable = {}; }},
    {"setOfOtherType", [](Mission& m) { statement(m, 4).value = statement(m, 0).value; }},
    {"commandWithAnArgument",
     [](Mission& m) { statement(m, 3).values = {m.variables[0].initial}; }},
    {"commandOutOfRange", [](Mission& m) { statement(m, 3).command = static_cast<Command>(99); }},
    {"returnInAlways",
     [](Mission& m) {
       m.always[0].transition = Transition::Return;
       m.always[0].target = {};
       m.always[0].arguments.clear();
     }},
    {"doneInState", [](Mission& m) { m.states[1].cases[0].transition = Transition::Done; }},
    {"exitInProfile", [](Mission& m) { doneCase(m).transition = Transition::Exit; }},
    {"doneKeptNowhere", [](Mission& m) { m.states[1].profile.done = {}; }},
    {"doneKeptInAState", [](Mission& m) { m.states[1].profile.done = {3}; }},
    {"argumentMissing", [](Mission& m) { m.always[0].arguments.clear(); }},
    {"argumentOfOtherType", [](Mission& m) { m.always[0].arguments[0] = m.variables[3].initial; }},
    {"argumentOfAnotherState",
     [](Mission& m) {
       m.states[0].cases[0].arguments[0] = m[m.states[1].cases[0].guard].operands[1];
     }},
    {"parameterOfAnotherState", [](Mission& m) { m.states[0].parameters = {{2}}; }},
    {"parameterLeftOut", [](Mission& m) { m.states[1].parameters.clear(); }},
    {"startWithParameters", [](Mission& m) { std::swap(m.states[0], m.states[1]); }},
    {"functionWithABody", [](Mission& m) { m.states[1].profile.behaviour = {0}; }},
    {"bodyWithArguments",
     [](Mission& m) { m.states[1].profile.arguments = {m.variables[0].initial}; }},
    {"variableMissing", [](Mission& m) { m.exprs[m.variables[1].initial.index].variable = {}; }},
    {"everyTickDecides",
     [](Mission& m) {
       m.every_tick = {static_cast<uint32_t>(m.blocks.size())};
       m.blocks.push_back({{statement(m, 0)}});  // sets what the case of `always` reads
     }},
    {"logOfAnotherState",
     [](Mission& m) {
       m.states[0].log.push_back({"x", m[m.states[1].cases[0].guard].operands[1], 0});
     }},
};

INSTANTIATE_TEST_SUITE_P(Values, ValidateWholeDamaged, testing::ValuesIn(kWholeDamages),
                         [](const auto& damage) { return damage.param.name; });
INSTANTIATE_TEST_SUITE_P(Code, ValidateWholeDamaged, testing::ValuesIn(kCodeDamages),
                         [](const auto& damage) { return damage.param.name; });

Mission talking() {
  return missionOf(kTalking + stateText("a", "case (gt (sensor \"peer.top\") 5:length) exit"));
}

TEST(Validate, AcceptsShares) {
  EXPECT_TRUE(validate(talking()).empty());
  Mission most = talking();
  for (uint32_t i = 3; i < 32; ++i) {
    most.shares.push_back(
        {"s" + std::to_string(i), {0}, {}, {}, 0, 1, 1, 600 + double{1.0 * i}, {}});
  }
  EXPECT_TRUE(validate(most).empty());
}

class ValidateTalkingDamaged : public testing::TestWithParam<Damage> {};

TEST_P(ValidateTalkingDamaged, IsFound) {
  Mission m = talking();
  GetParam().make(m);
  EXPECT_FALSE(validate(m).empty());
}

const Damage kShareDamages[] = {
    {"noClock", [](Mission& m) { m.utc = {}; }},
    {"clockAlone",
     [](Mission& m) {
       m = sound();
       m.utc = {0};
     }},
    {"clockMissing", [](Mission& m) { m.utc = {9}; }},
    {"clockHeard", [](Mission& m) { m.utc = {3}; }},
    {"namesTwice", [](Mission& m) { m.shares[1].name = "top"; }},
    {"periodsBackwards", [](Mission& m) { m.shares[0].period_s = 700; }},
    {"periodNone", [](Mission& m) { m.shares[0].period_s = m.shares[1].period_s = 0; }},
    {"periodEndless",
     [](Mission& m) { m.shares[2].period_s = std::numeric_limits<double>::infinity(); }},
    {"stepNone", [](Mission& m) { m.shares[0].step = 0; }},
    {"stepNaN", [](Mission& m) { m.shares[0].step = kInvalidNumber; }},
    {"lowestNaN", [](Mission& m) { m.shares[0].lowest = kInvalidNumber; }},
    {"highestEndless", [](Mission& m) { m.shares[0].step = 1e306; }},
    {"valuesNone", [](Mission& m) { m.shares[0].values = 0; }},
    {"valuesTooMany", [](Mission& m) { m.shares[2].values = UINT32_MAX; }},
    {"sensorMissing", [](Mission& m) { m.shares[0].sensor = {9}; }},
    {"tellsNothing", [](Mission& m) { m.shares[0].sensor = {}; }},
    {"tellsWhatIsHeard", [](Mission& m) { m.shares[0].sensor = {3}; }},
    {"tellsTwo", [](Mission& m) { m.shares[0].variable = {0}; }},
    {"variableMissing", [](Mission& m) { m.shares[1].variable = {1}; }},
    {"truthOfThree", [](Mission& m) { m.shares[1].values = 3; }},
    {"peerMissing", [](Mission& m) { m.shares[0].peer = {9}; }},
    {"peerOfTheVehicle", [](Mission& m) { m.shares[2].peer = {1}; }},
    {"peerOfTwo", [](Mission& m) { m.shares[1].peer = m.shares[0].peer; }},
    {"heardOfNoShare", [](Mission& m) { m.shares[0].peer = {}; }},
    {"heardInFeet", [](Mission& m) { m.sensors[3].to_si = 0.3048; }},
    {"heardBySymbol", [](Mission& m) { m.sensors[3].symbol = "poll"; }},
    {"variationHeard",
     [](Mission& m) {
       m.sensors[4].type = {TypeKind::Quantity, support::dimension::angle};
       m.compass = {{4}, {}};
     }},
    {"tooLargeForAFrame",
     [](Mission& m) {
       for (int i = 0; i < 8; ++i) {
         m.shares.push_back({"s" + std::to_string(i), {0}, {}, {}, 0, 1, UINT32_MAX - 1, 600, {}});
       }
     }},
    {"tooMany",
     [](Mission& m) {
       for (int i = 0; i < 30; ++i) {
         m.shares.push_back({"s" + std::to_string(i), {0}, {}, {}, 0, 1, 1, 601.0 + i, {}});
       }
     }},
};

INSTANTIATE_TEST_SUITE_P(Shares, ValidateTalkingDamaged, testing::ValuesIn(kShareDamages),
                         [](const auto& damage) { return damage.param.name; });

Mission namedTalking() {
  return missionOf(kNamedTalking + stateText("a", "case (gt (sensor \"ada.top\") 5:length) exit"));
}

TEST(Validate, AcceptsNamedVehicles) {
  EXPECT_TRUE(validate(namedTalking()).empty());
}

class ValidateNamedDamaged : public testing::TestWithParam<Damage> {};

TEST_P(ValidateNamedDamaged, IsFound) {
  Mission m = namedTalking();
  GetParam().make(m);
  EXPECT_FALSE(validate(m).empty());
}

const Damage kNamedDamages[] = {
    {"nameTwice", [](Mission& m) { m.vehicles[2] = "ada"; }},
    {"namesTooMany",
     [](Mission& m) {
       for (int i = 3; i < 16; ++i) {
         m.vehicles.push_back("v" + std::to_string(i));
       }
     }},
    {"addressNone", [](Mission& m) { m.shares[0].named[0].address = 0; }},
    {"addressBeyond", [](Mission& m) { m.shares[0].named[1].address = 4; }},
    {"addressTwice", [](Mission& m) { m.shares[0].named[1].address = 1; }},
    {"sensorNone", [](Mission& m) { m.shares[0].named[0].sensor = {}; }},
    {"sensorOfTheVehicle", [](Mission& m) { m.shares[0].named[0].sensor = {0}; }},
    {"sensorOfTwo", [](Mission& m) { m.shares[0].named[1].sensor = m.shares[0].named[0].sensor; }},
    {"sensorOfNone", [](Mission& m) { m.shares[0].named.pop_back(); }},
};

INSTANTIATE_TEST_SUITE_P(Vehicles, ValidateNamedDamaged, testing::ValuesIn(kNamedDamages),
                         [](const auto& damage) { return damage.param.name; });

TEST(ShareMessages, AreThoseOfAPeriod) {
  const Mission mission = talking();
  const auto messages = messagesOf(mission);
  ASSERT_EQ(messages.size(), 2U);
  EXPECT_EQ(messages[0].first, 0U);
  EXPECT_EQ(messages[0].count, 2U);
  EXPECT_EQ(messages[0].bytes, 3U);  // 256 * 2002 * 3
  EXPECT_EQ(messages[0].bits, 21U);
  EXPECT_EQ(messages[1].first, 2U);
  EXPECT_EQ(messages[1].count, 1U);
  EXPECT_EQ(messages[1].bytes, 3U);
  EXPECT_EQ(messages[1].bits, 18U);
}

/// What has at most 1024 values, unknown counted, is a mini packet; of these, the signatures of a
/// mission differ in their low 3 bits, so that there are no more than 8.
TEST(ShareMessages, SmallOnesAreMiniPackets) {
  Mission mission = talking();
  Share small = mission.shares[2];
  small.lowest = 0;
  small.step = 1;
  mission.shares.clear();
  for (uint32_t i = 0; i < 10; ++i) {
    small.name = "small" + std::to_string(i);
    small.values = 1023 - i;
    small.period_s = 60.0 * (i + 1);
    mission.shares.push_back(small);
  }
  const auto messages = messagesOf(mission);
  ASSERT_EQ(messages.size(), 10U);
  std::set<uint32_t> low, whole;
  for (size_t i = 0; i < messages.size(); ++i) {
    EXPECT_EQ(messages[i].mini_bits, i < 8 ? 13U : 0U) << i;
    EXPECT_TRUE(whole.insert(messages[i].signature).second) << i;
    EXPECT_TRUE(i >= 8 || low.insert(messages[i].signature % 8).second) << i;
  }
  mission.shares.resize(1);
  mission.shares[0].values = 1024;
  EXPECT_EQ(messagesOf(mission)[0].mini_bits, 0U);
  EXPECT_EQ(messagesOf(mission)[0].bytes, 3U);
}

/// The same, for any name in this mission and any reader; another, if a word
/// of what is sent is another. Eight bits cannot tell all, so a few of each are tried.
TEST(ShareMessages, TheSignatureIsThatOfWhatIsTold) {
  Mission mission = talking();
  const std::vector<Share> shares = mission.shares;
  const auto signatureOf = [&](std::vector<Share> sent) {
    mission.shares = std::move(sent);
    return messageOf(mission, 0, static_cast<uint32_t>(mission.shares.size())).signature;
  };
  const auto signature = [&](const Share& share) { return signatureOf({share}); };
  const uint32_t own = signature(shares[2]);
  EXPECT_EQ(own, 75U);  // every program that shares this has this one
  Share same = shares[2];
  same.peer = {4};
  same.range.begin = 77;
  EXPECT_EQ(signature(same), own);
  int others = 0;
  for (int i = 1; i <= 8; ++i) {
    std::array<Share, 5> changed;
    changed.fill(shares[2]);
    changed[0].name += std::to_string(i);
    changed[1].lowest += i;
    changed[2].step += i;
    changed[3].values += static_cast<uint32_t>(i);
    changed[4].period_s += i;
    for (const Share& share : changed) {
      others += signature(share) != own ? 1 : 0;
    }
  }
  EXPECT_GE(others, 38);
  EXPECT_NE(signatureOf({shares[0], shares[1]}), signatureOf({shares[1], shares[0]}));
  mission.sensors[shares[2].sensor.index].type = {TypeKind::Quantity, support::dimension::time};
  EXPECT_NE(signature(shares[2]), own) << "seconds are not degrees";
}

/// `m` is read by what is `watched` or is the `initial` value of a variable of a state; then every
/// tick sets it.
Mission withEveryTick(const std::string& watched, const std::string& initial) {
  Mission m = missionOf(
      kHeader + "variable m: length mission variable s: length state of a initial m 5:length " +
      "temporal held always (lt " + watched + " 4:length) for 8:time " +
      "always case (temporal 0) exit state a initial s " + initial +
      " route drift () profile to ((sensor depth), 5:time) case true exit");
  Statement set;
  set.variable = {0};
  set.value = m.variables[0].initial;
  m.every_tick = {static_cast<uint32_t>(m.blocks.size())};
  m.blocks.push_back({{set}});
  return m;
}

TEST(Validate, NothingReadsWhatEveryTickSets) {
  EXPECT_TRUE(validate(withEveryTick("(sensor depth)", "5:length")).empty());
  EXPECT_FALSE(validate(withEveryTick("(var m)", "5:length")).empty());
  EXPECT_FALSE(validate(withEveryTick("(sensor depth)", "(var m)")).empty());
}

}  // namespace
}  // namespace glider::ir
