// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// C functions and the SBC's own sensors, as ir/README.md says them.

#include "ir/eval/arithmetic.h"
#include "ir/eval/interpreter.h"
#include "tests/unit/ir/missions.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

namespace glider::ir {
namespace {

const std::string kExternals = kHeader + R"(sensor ping: length symbol ping id 65280 encoding linear
  to_si 1 lowest 0 highest 100 stale_after 10
function f symbol f (x: length): number lowest -inf highest inf
function g symbol g (): number lowest 0 highest 5
function met symbol met (c: bool): bool lowest -inf highest inf
)";

/// Runs a mission and writes down what it calls.
class Called {
 public:
  explicit Called(const std::string& text)
      : mission_(missionOf(kExternals + text)), interpreter_(mission_, 2, externals()) {
    result = interpreter_.start();
  }
  void tick(double time) {
    calls.clear();
    result = interpreter_.tick(time, {});
  }

  std::string calls;
  TickResult result;
  double answer = 1;           ///< of every function
  double ping = std::nan("");  ///< the sensor's next reading
  double value(uint32_t variable) const { return result.variables.at(variable); }

 private:
  Externals externals() {
    return {[this](const Function& f, std::span<const double> arguments) {
              calls += f.name;
              for (const double argument : arguments) {
                calls += fmt::format(" {}", argument);
              }
              calls += ";";
              return answer;
            },
            [this](const Sensor& s, double time) {
              calls += fmt::format("{}@{};", s.name, time);
              return ping;
            }};
  }

  Mission mission_;
  Interpreter interpreter_;
};

std::string stateA(const std::string& cases) {
  return "state a route drift () profile glide () " + cases;
}

TEST(Externals, AUseIsCalledOnceATickHoweverOftenItIsRead) {
  Called run(
      "use f variable x: length mission initial x 1:length " +
      stateA(
          "case (gt (call 0 (var x)) 5) exit "
          "case true do set x 2:length if (gt (call 0 (var x)) 0) log \"again\" () end end stay"));
  EXPECT_EQ(run.calls, "ping@0;");
  run.tick(4);
  EXPECT_EQ(run.calls, "ping@4;f 1;") << "with the arguments of the first time";
  run.tick(8);
  EXPECT_EQ(run.calls, "ping@8;f 2;");
  EXPECT_EQ(run.result.notes.size(), 1U);
}

TEST(Externals, WhatAlwaysWatchesIsCalledBeforeWhatTheStateWatches) {
  Called run(
      "use f use g temporal became state a (gt (call 0 1:length) 5) "
      "temporal became always (gt (call 1) 5) " +
      stateA("case (temporal 0) stay case (temporal 1) stay"));
  EXPECT_EQ(run.calls, "ping@0;g;f 1;");
  run.tick(4);
  EXPECT_EQ(run.calls, "ping@4;g;f 1;") << "on every tick as at the start";
}

TEST(Externals, TwoUsesAreTwoCallsInTheOrderOfTheText) {
  Called run("use f use g use f " +
             stateA("case (lt (add (add (call 0 5:length) (call 1)) (call 2 6:length)) 0) exit"));
  run.tick(4);
  EXPECT_EQ(run.calls, "ping@4;f 5;g;f 6;");
}

TEST(Externals, NothingIsLeftOutForWhatTheOtherOperandIsWorth) {
  Called run("use g " + stateA("case (and false (gt (call 0) 0)) exit"));
  run.tick(4);
  EXPECT_EQ(run.calls, "ping@4;g;");
}

TEST(Externals, AGuardAfterTheOneThatFiresIsNotEvaluated) {
  Called run("use g use f " +
             stateA("case (gt (call 0) 0) stay case (gt (call 1 1:length) 0) exit"));
  run.tick(4);
  EXPECT_EQ(run.calls, "ping@4;g;");
  run.answer = -1;
  run.tick(8);
  EXPECT_EQ(run.calls, "ping@8;g;f 1;");
}

TEST(Externals, ResultsSettleAndKeepTheirRange) {
  Called run("use g variable x: number mission initial x 9 " +
             stateA("case true do set x (call 0) end stay"));
  const auto given = [&](double answer) {
    run.answer = answer;
    run.tick(4);
    return run.value(0);
  };
  EXPECT_EQ(given(5), 5);
  EXPECT_EQ(given(5.1), 5) << "unknown changes nothing";
  EXPECT_EQ(given(1e-320), 0);
  EXPECT_EQ(given(-1), 0);
  EXPECT_EQ(given(INFINITY), 0);
  EXPECT_EQ(given(NAN), 0);
}

TEST(Externals, TruthValuesPassAsNumbers) {
  Called run("use met use met use met variable x: bool mission initial x false " +
             stateA("case (call 0 (lt (sensor depth) 5:length)) do set x true end stay "
                    "case (call 1 true) stay case (not (call 2 false)) do set x true end stay"));
  run.answer = 0;
  run.tick(4);
  EXPECT_EQ(run.calls, "ping@4;met nan;met 1;met 0;");
  EXPECT_EQ(run.value(0), 1) << "0 is false";
  run.answer = -3;
  run.tick(8);
  EXPECT_EQ(run.calls, "ping@8;met nan;") << "any other known number is true";
}

TEST(Externals, WhatIsWatchedCallsOnEveryTick) {
  Called run("use g temporal held state a (gt (call 0) 0) for 8:time " +
             stateA("case false exit case (temporal 0) exit"));
  EXPECT_EQ(run.calls, "ping@0;g;");
  run.tick(4);
  EXPECT_EQ(run.calls, "ping@4;g;");
}

TEST(Externals, ASensorOfItsOwnIsLikeAnyOther) {
  Called run(
      "variable x: length mission initial x 1:length variable age: time mission "
      "initial age 0:time " +
      stateA("case true do set x (sensor ping) set age (age ping) end stay"));
  run.ping = 7;
  run.tick(4);
  EXPECT_EQ(run.value(0), 7);
  EXPECT_EQ(run.value(1), 0);
  run.ping = NAN;
  run.tick(12);
  EXPECT_EQ(run.value(0), 7) << "no new reading: the old one, 8 s old";
  EXPECT_EQ(run.value(1), 8);
  run.tick(16);
  EXPECT_EQ(run.result.notes.size(), 1U) << "stale: unknown";
  run.ping = 101;
  run.tick(20);
  EXPECT_EQ(run.value(0), 7) << "outside its range: unknown";
  EXPECT_EQ(run.value(1), 0);
}

TEST(Externals, AfterExitNothingIsCalled) {
  Called run("use g " + stateA("case (gt (call 0) 0) exit"));
  run.tick(4);
  EXPECT_TRUE(run.result.finished);
  run.tick(8);
  EXPECT_EQ(run.calls, "");
}

}  // namespace
}  // namespace glider::ir
