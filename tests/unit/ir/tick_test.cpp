// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The rules of a tick in ir/README.md, each by itself.

#include "ir/eval/interpreter.h"
#include "tests/unit/ir/missions.h"

#include <fmt/format.h>

#include <limits>

namespace glider::ir {
namespace {

constexpr SensorId kDepth{0};
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
using Updates = std::vector<SensorUpdate>;

/// A behaviour of each kind that is written in the language.
const std::string kWritten = kHeader + R"(behaviour profile yo symbol "" () reads ()
behaviour route way symbol "" () reads ()
)";

/// A guard that is true at this mission time only.
std::string at(int time) {
  return fmt::format("(eq missiontime {}:time)", time);
}

class Flight {
 public:
  explicit Flight(const std::string& text, uint32_t depth = 3)
      : mission_(missionOf(text)), interpreter_(mission_, depth) {}

  const TickResult& start(const Updates& frame = {}) { return last_ = interpreter_.start(frame); }
  const TickResult& start(const Updates& frame, const std::vector<double>& parameters) {
    return last_ = interpreter_.start(frame, parameters);
  }
  const TickResult& tick(double time, const Updates& frame = {}) {
    return last_ = interpreter_.tick(time, frame);
  }
  [[nodiscard]] double variable(const std::string& name) const {
    for (size_t i = 0; i < mission_.variables.size(); ++i) {
      if (mission_.variables[i].name == name) {
        return last_.variables.at(i);
      }
    }
    ADD_FAILURE() << name;
    return 0;
  }
  [[nodiscard]] std::string state() const { return mission_[last_.state].name; }
  [[nodiscard]] std::string notes() const {
    std::string text;
    for (const Note& note : last_.notes) {
      text += note.kind == NoteKind::Log ? note.text : "?" + note.text;
      for (double value : note.values) {
        text += fmt::format(" {}", value);
      }
      text += ";";
    }
    return text;
  }
  [[nodiscard]] const TickResult& last() const { return last_; }

 private:
  Mission mission_;
  Interpreter interpreter_;
  TickResult last_;
};

std::string log(const std::string& text) {
  return "do log " + text + " () end ";
}

TEST(Tick, TriesTheFourListsInTurnAndStayGoesOn) {
  Flight run(kWritten + "always case true " + log("always") + "stay case true " + log("no") +
             "stay state a route way begin case true " + log("route") +
             "stay end profile yo begin case true " + log("profile") + "stay end case true " +
             log("state") + "stay");
  run.start();
  EXPECT_EQ(run.notes(), "");
  run.tick(4);
  EXPECT_EQ(run.notes(), "always;state;profile;route;");
  EXPECT_EQ(run.last().fired, (std::array<std::optional<uint32_t>, 4>{0U, 0U, 0U, 0U}));
  EXPECT_EQ(run.last().moved, std::nullopt);
}

TEST(Tick, ATransitionEndsItAndEntriesRunInOrder) {
  Flight run(kWritten + "state a route way begin case true " + log("no") +
             "stay end profile yo begin end case true " + log("leave") + "goto b " +
             "state b route way begin entry " + log("route") + "case true " + log("late") +
             "stay end profile yo begin entry " + log("profile") + "end entry " + log("state") +
             "case true exit");
  run.start();
  run.tick(4);
  EXPECT_EQ(run.notes(), "leave;state;profile;route;");
  EXPECT_EQ(run.last().moved, (CaseOf{ListKind::State, 0}));
  run.tick(8);
  EXPECT_TRUE(run.last().finished);
  EXPECT_EQ(run.notes(), "") << "exit ends the tick before the route";
  run.tick(12);
  EXPECT_EQ(run.last().firedIn(ListKind::State), std::nullopt);
  EXPECT_EQ(run.last().moved, std::nullopt);
}

TEST(Tick, AfterAReturnTheStatesOwnCasesComeBeforeAlways) {
  Flight run(kHeader + "always case (ge missiontime 4:time) call avoid " +
             stateText("a", "case " + at(12) + " goto b") + stateText("avoid", "case true return") +
             stateText("b", "case false exit"));
  run.start();
  run.tick(4);
  EXPECT_EQ(run.state(), "avoid");
  EXPECT_EQ(run.last().moved, (CaseOf{ListKind::Always, 0}));
  EXPECT_EQ(run.last().limit, 0u);
  run.tick(8);
  EXPECT_EQ(run.state(), "a");
  EXPECT_TRUE(run.last().just_returned);
  EXPECT_EQ(run.last().limit, kNoLimit);
  run.tick(12);
  EXPECT_EQ(run.state(), "b") << "its own case, though always holds too";
  run.tick(16);
  EXPECT_EQ(run.state(), "avoid") << "always first again";
}

TEST(Tick, AfterAReturnAlwaysComesNextIfTheStateStays) {
  Flight run(kHeader + "always case (ge missiontime 4:time) call avoid " +
             stateText("a", "case true stay") + stateText("avoid", "case true return"));
  run.start();
  run.tick(4);
  run.tick(8);
  run.tick(12);
  EXPECT_EQ(run.state(), "avoid");
  EXPECT_EQ(run.last().firedIn(ListKind::State), 0u);
}

TEST(Tick, OnlyEarlierCasesOfAlwaysInterruptWhatAlwaysEntered) {
  Flight run(kHeader + "always case " + at(12) +
             " call first case (ge missiontime 4:time) call second " + "case " + at(8) + " exit " +
             stateText("a", "") + stateText("first", "") +
             stateText("second", "case " + at(20) + " goto a"));
  run.start();
  run.tick(4);
  EXPECT_EQ(run.state(), "second");
  EXPECT_EQ(run.last().limit, 1u);
  run.tick(8);
  EXPECT_FALSE(run.last().finished) << "case 2 is written below the one that fired";
  run.tick(12);
  EXPECT_EQ(run.state(), "first");
  EXPECT_EQ(run.last().limit, 0u);
  EXPECT_EQ(run.last().stack, (std::vector<Frame>{{{0}, 0, kNoLimit}, {{2}, 4, 1}}));
}

TEST(Tick, AnAlwaysCaseWhoseTargetIsInUseFallsThrough) {
  Flight run(kHeader + "always case true goto a case " + at(8) + " call b " +
             stateText("a", "case " + at(4) + " call c") + stateText("b", "") + stateText("c", ""));
  run.start();
  run.tick(4);
  EXPECT_EQ(run.state(), "c") << "a is current";
  run.tick(6);
  EXPECT_EQ(run.state(), "c") << "a is on the stack";
  run.tick(8);
  EXPECT_EQ(run.state(), "b") << "the next case fires";
}

TEST(Tick, LimitsAreKeptByCallsAndForgottenByGotos) {
  Flight run(kHeader + "always case false exit case " + at(4) + " goto h " + stateText("a", "") +
             stateText("h", "case " + at(8) + " call k case " + at(16) + " goto a") +
             stateText("k", "case " + at(12) + " return"));
  run.start();
  EXPECT_EQ(run.tick(4).limit, 1u);
  EXPECT_EQ(run.tick(8).limit, 1u);
  EXPECT_EQ(run.last().stack.at(0).limit, 1u);
  EXPECT_EQ(run.tick(12).limit, 1u);
  EXPECT_EQ(run.tick(16).limit, kNoLimit);
}

TEST(Tick, DoneIsSeenByTheState) {
  Flight run(
      kWritten + "variable d: bool profile of a variable v: bool state of a " +
      "state a initial d false initial v false route drift () profile yo done d begin case " +
      at(4) + " done end case (var d) do set v true end stay case " + at(12) + " goto a");
  run.start();
  EXPECT_EQ(run.variable("d"), 0);
  run.tick(4);
  EXPECT_EQ(run.variable("d"), 1);
  EXPECT_EQ(run.variable("v"), 0);
  run.tick(8);
  EXPECT_EQ(run.variable("v"), 1);
  run.tick(12);
  EXPECT_EQ(run.variable("v"), 1) << "the first true case fires alone";
}

TEST(Tick, ArgumentsAreEvaluatedInTheOldStateAllBeforeAnyIsGiven) {
  Flight run(
      kHeader +
      "variable x: time argument of leg variable y: time argument of leg "
      "variable z: time state of leg " +
      "state a route drift () profile glide () case " + at(8) + " goto leg (statetime, 1:time) " +
      "state leg (x, y) initial z (add (var x) statetime) route drift () profile glide () case " +
      at(16) + " do set z 3:time end goto leg ((var y), (var x))");
  run.start();
  EXPECT_NE(run.variable("x"), run.variable("x")) << "not started: unknown";
  run.tick(8);
  EXPECT_EQ(run.variable("x"), 8);
  EXPECT_EQ(run.variable("y"), 1);
  EXPECT_EQ(run.variable("z"), 8) << "initial values see arguments and the new state's clock";
  run.tick(16);
  EXPECT_EQ(run.variable("x"), 1);
  EXPECT_EQ(run.variable("y"), 8);
  EXPECT_EQ(run.variable("z"), 1);
}

TEST(Tick, VariablesSurviveCallsAndRestartWithGoto) {
  Flight run(kHeader + "variable n: number state of a variable m: number mission initial m 0 " +
             "state a initial n 0 route drift () profile glide () case " + at(4) +
             " do set n 7 set m 7 end call b case " + at(12) + " goto a " +
             stateText("b", "case " + at(8) + " return"));
  run.start();
  run.tick(4);
  run.tick(8);
  EXPECT_EQ(run.variable("n"), 7) << "return restarts nothing";
  run.tick(12);
  EXPECT_EQ(run.variable("n"), 0);
  EXPECT_EQ(run.variable("m"), 7);
}

TEST(Tick, ASetSeenByLaterLists) {
  Flight run(
      kHeader + "variable x: length mission initial x 1:length " +
      "state a route drift () profile to ((var x), 0:time) case true do set x 2:length end stay");
  run.start();
  EXPECT_EQ(std::get<ActivityRun>(run.last().actions.at(0)).arguments.at(0), 1);
  run.tick(4);
  EXPECT_EQ(std::get<ActivityRun>(run.last().actions.at(0)).arguments.at(0), 2)
      << "a C function's arguments are evaluated when its list is tried";
}

TEST(Tick, AnUnknownSetOrInitialValue) {
  Flight run(kHeader + "variable x: length mission initial x (sensor depth) " +
             stateText("a", "case true do set x (add (sensor depth) 1:length) end stay"));
  run.start();
  EXPECT_NE(run.variable("x"), run.variable("x"));
  run.tick(4, {{kDepth, 5}});
  EXPECT_EQ(run.variable("x"), 6);
  EXPECT_EQ(run.notes(), "");
  run.tick(8, {{kDepth, kNaN}});
  EXPECT_EQ(run.variable("x"), 6);
  EXPECT_EQ(run.notes(), "?x;");
}

TEST(Tick, AnUnknownIfTakesNeitherBranch) {
  Flight run(kHeader + stateText("a",
                                 "case true do if (gt (sensor depth) 5:length) log deep () "
                                 "else log shallow () end log after () end stay"));
  run.start();
  run.tick(4);
  EXPECT_EQ(run.notes(), "after;");
  run.tick(8, {{kDepth, 9}});
  EXPECT_EQ(run.notes(), "deep;after;");
  run.tick(12, {{kDepth, 1}});
  EXPECT_EQ(run.notes(), "shallow;after;");
}

TEST(Tick, CommandsWithAnUnknownArgumentAreRefused) {
  Flight run(
      kHeader +
      stateText("a", "case true do descend ((sensor depth), 0.4:angle) surface () end stay"));
  run.start();
  run.tick(4);
  const auto& first = std::get<CommandRun>(run.last().actions.at(0));
  EXPECT_EQ(first.command, Command::Descend);
  EXPECT_TRUE(first.refused);
  EXPECT_FALSE(std::get<CommandRun>(run.last().actions.at(1)).refused);
  EXPECT_EQ(std::get<ActivityRun>(run.last().actions.at(2)).list, ListKind::Profile)
      << "in the order in which they happened";
  EXPECT_FALSE(std::get<CommandRun>(run.tick(8, {{kDepth, 3}}).actions.at(0)).refused);
}

TEST(Tick, KeepsSixteenNotesAndSixtyFourValues) {
  std::string many;
  for (int i = 0; i < 18; ++i) {
    many += fmt::format("log n{} () ", i);
  }
  std::string wide = "log w (";
  for (int i = 0; i < 40; ++i) {
    wide += fmt::format("{}{}", i == 0 ? "" : ", ", i);
  }
  wide += ") ";
  Flight run(kHeader + stateText("a", "case " + at(4) + " do " + many + "end stay case " + at(8) +
                                          " do " + wide + wide + "log x () log y (1) end stay"));
  run.start();
  run.tick(4);
  EXPECT_EQ(run.last().notes.size(), 16u);
  EXPECT_EQ(run.last().lost_notes, 2u);
  run.tick(8);
  ASSERT_EQ(run.last().notes.size(), 4u);
  EXPECT_EQ(run.last().notes[1].values.size(), 24u) << "those before the 65th are kept";
  EXPECT_EQ(run.last().notes[3].values.size(), 0u);
  EXPECT_EQ(run.last().lost_notes, 2u);
  run.tick(12);
  EXPECT_EQ(run.last().notes.size() + run.last().lost_notes, 0u);
}

TEST(Tick, Became) {
  Flight run(
      kHeader + "temporal became state a (gt (sensor depth) 5:length) " +
      stateText("a", "case (temporal 0) do log turned () end stay case " + at(20) + " goto a"));
  run.start({{kDepth, 9}});
  run.tick(4, {{kDepth, 9}});
  EXPECT_EQ(run.notes(), "") << "true at the entry counts as already true";
  run.tick(8, {{kDepth, kNaN}});
  run.tick(12, {{kDepth, 9}});
  EXPECT_EQ(run.notes(), "turned;") << "unknown before";
  run.tick(16, {{kDepth, 9}});
  EXPECT_EQ(run.notes(), "");
  run.tick(20, {{kDepth, 1}});
  run.tick(24, {{kDepth, 9}});
  EXPECT_EQ(run.notes(), "turned;");
}

TEST(Tick, HeldCountsFromTheEntryAndFromTheTurn) {
  Flight run(kHeader + "temporal held state a (gt (sensor depth) 5:length) for 8:time " +
             stateText("a", "case (temporal 0) do log held () end stay"));
  run.start({{kDepth, 9}});
  EXPECT_EQ(run.tick(4, {{kDepth, 9}}).notes.size(), 0u);
  EXPECT_EQ(run.tick(8, {{kDepth, 9}}).notes.size(), 1u);
  EXPECT_EQ(run.tick(12, {{kDepth, 1}}).notes.size(), 0u);
  EXPECT_EQ(run.tick(16, {{kDepth, 9}}).notes.size(), 0u);
  EXPECT_EQ(run.tick(20, {{kDepth, 9}}).notes.size(), 0u);
  EXPECT_EQ(run.tick(24, {{kDepth, 9}}).notes.size(), 1u);
}

TEST(Tick, TemporalsNestAndRestartOnReturnButThoseOfAlwaysDoNot) {
  Flight run(kHeader + "temporal held always (gt (sensor depth) 5:length) for 12:time " +
             "temporal held state a (gt (sensor depth) 5:length) for 12:time " +
             "temporal became state a (temporal 1) " + "always case (temporal 0) " + log("always") +
             "stay " +
             stateText("a", "case (temporal 2) " + log("own") + "stay case " + at(4) + " call b") +
             stateText("b", "case " + at(8) + " return"));
  run.start({{kDepth, 9}});
  run.tick(4, {{kDepth, 9}});
  run.tick(8, {{kDepth, 9}});
  run.tick(12, {{kDepth, 9}});
  EXPECT_EQ(run.notes(), "always;");
  run.tick(16, {{kDepth, 9}});
  run.tick(20, {{kDepth, 9}});
  EXPECT_EQ(run.notes(), "always;own;") << "12 s after the return";
  run.tick(24, {{kDepth, 9}});
  EXPECT_EQ(run.notes(), "always;") << "became is true once";
}

TEST(Tick, WindowsAreUnknownUntilCoveredAndSurviveCalls) {
  Flight run(kHeader + "temporal mean state a (sensor depth) over 8 " +
             "state a route drift () profile to ((temporal 0), 0:time) case " + at(4) + " call b " +
             stateText("b", "case " + at(8) + " return"));
  auto mean = [&] { return std::get<ActivityRun>(run.last().actions.at(0)).arguments.at(0); };
  run.start({{kDepth, 2}});
  EXPECT_NE(mean(), mean());
  run.tick(4, {{kDepth, 4}});
  run.tick(8, {{kDepth, 6}});
  EXPECT_EQ(mean(), 4) << "it advances on return and was not restarted";
}

TEST(Tick, ParametersComeBeforeTheVariablesThatReadThem) {
  const std::string text =
      kHeader + "variable p: length parameter lowest 10 highest 30 variable q: bool parameter " +
      "variable x: length mission initial p 20:length initial q false " +
      "initial x (mul 2 (var p)) condition (ge (var p) 15:length) " + stateText("a", "");
  Flight run(text);
  run.start();
  EXPECT_EQ(run.variable("x"), 40);
  Flight other(text);
  other.start({}, {30, 1});
  EXPECT_EQ(other.variable("x"), 60);
  EXPECT_EQ(other.variable("q"), 1);
  EXPECT_EQ(failedCondition(missionOf(text), std::vector<double>{20, 0}), std::nullopt);
  EXPECT_EQ(failedCondition(missionOf(text), std::vector<double>{12, 0}), 0u);
}

TEST(Tick, DeepExpressionsNeedNoDeepStack) {
  Mission m = missionOf(kHeader + stateText("a", "case true stay"));
  ExprId last = m.states[0].cases[0].guard;
  for (int i = 0; i < 200'000; ++i) {
    Expr e;
    e.op = Op::Not;
    e.type = {TypeKind::Bool, {}};
    e.operands[0] = last;
    m.exprs.push_back(e);
    last = {static_cast<uint32_t>(m.exprs.size() - 1)};
  }
  m.states[0].cases[0].guard = last;
  Interpreter i(m, 0);
  i.start();
  EXPECT_EQ(i.tick(4, {}).firedIn(ListKind::State), 0u);
}

TEST(TickDeathTest, RefusesAVariableOutsideItsRange) {
  Flight run(kHeader + "variable x: length mission lowest 0 highest 5 initial x 1:length " +
             stateText("a", "case true do set x (sensor depth) end stay"));
  run.start();
  EXPECT_DEATH(run.tick(4, {{kDepth, 9}}), "outside its range");
}

}  // namespace
}  // namespace glider::ir
