// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Rules of ir/README.md, each in a mission that shows it: what one step may do, and must.

#include "ir/certify/smt.h"
#include "tests/unit/certify/judge.h"
#include "tests/unit/ir/missions.h"
#include "tests/unit/ir/slocum.h"

#include <fmt/format.h>

#include <gmock/gmock.h>
#include <set>

namespace glider::ir::certify {
namespace {

constexpr double kGap = 20;  ///< s

/// The steps of a mission.
class Steps {
 public:
  explicit Steps(const std::string& body)
      : Steps(compiled("mission m\nrequire always missiontime >= 0 s\n" + body)) {}
  explicit Steps(Mission mission) : mission_(std::move(mission)) {}

  /// Whether a step from the configuration with these words, in which `before` holds, may end as a
  /// case with the words `ending` and with `after`; both are formulas over names.
  bool can(const std::string& from, const std::string& before, const std::string& ending,
           const std::string& after) const {
    const Step step = stepFrom(from);
    std::string script = step.text + fmt::format("(assert {})\n", before);
    std::vector<Term> ways{"false"};
    std::string definitions;
    for (const Ending& e : step.endings) {
      if (!e.words.contains(ending)) {
        continue;
      }
      const std::string name = fmt::format("glider.after{}", ways.size());
      definitions += fmt::format("(define-fun {} ({}) Bool {})\n", name, formals(e), after);
      ways.push_back(
          conjunction({e.condition, e.values.empty() ? Term("true") : operation(name, e.values)}));
    }
    const auto answers = answersTo("(set-logic ALL)\n" + definitions + script + "(assert " +
                                   disjunction(ways) + ")\n(check-sat)\n");
    EXPECT_THAT(answers, testing::ElementsAre(testing::AnyOf("sat", "unsat")));
    return answers.at(0) == "sat";
  }
  /// Whether it may end so, and then always with `after`.
  bool must(const std::string& from, const std::string& before, const std::string& ending,
            const std::string& after) const {
    return can(from, before, ending, "true") && !can(from, before, ending, "(not " + after + ")");
  }

  [[nodiscard]] std::set<std::string> configurations() const {
    std::set<std::string> words;
    for (const Configuration& at : configurationsOf(mission_)) {
      words.insert(wordsOf(mission_, at));
    }
    return words;
  }

 private:
  [[nodiscard]] std::string formals(const Ending& e) const {
    std::string all;
    if (e.to) {
      for (const Name& n : namesIn(mission_, mission_.requirements[0], *e.to)) {
        all += fmt::format("({} {})", n.text, n.truth ? "Bool" : "Real");
      }
    }
    return all.empty() ? "(|time| Real)" : all;
  }

  [[nodiscard]] Step stepFrom(const std::string& from) const {
    const Facts facts = factsOf(mission_);
    const Setting setting{mission_, slocum(), mission_.requirements[0], facts};
    if (from == "start") {
      return startOf(setting);
    }
    for (const Configuration& at : configurationsOf(mission_)) {
      if (wordsOf(mission_, at) == from) {
        return stepOf(setting, at, kGap);
      }
    }
    ADD_FAILURE() << "no configuration " << from;
    return {};
  }

  Mission mission_;
};

/// A state whose profile and route command nothing of interest.
std::string state(const std::string& name, const std::string& cases,
                  const std::string& profile = "surfaced") {
  return fmt::format(
      "state {}\nbegin\n  flightprofile {}\n"
      "  sensors missiontime, statetime, resumetime, depth, temp\n  events\n{}\nend\n",
      name, profile, cases);
}

class Rules : public testing::Test {
 protected:
  void SetUp() override { NEEDS_CVC5(); }
};

TEST_F(Rules, L1ToL4WhatIsOnTheStackAndTheLimit) {
  const Steps steps("always\n  case temp > 20 degC call x\n  case temp > 10 degC call y\n" +
                    state("a", "case temp > 5 degC call b\ncase temp > 4 degC goto c") +
                    state("b", "case true return") + state("c", "case true exit") +
                    state("x", "case true return") + state("y", "case true return"));
  const std::set<std::string> expected{
      "`a`", "`a`, just returned to", "`b`, called by `a`", "`b`, called by `a`, just returned to",
      // `always` calls x (case 1) with limit 0, and y (case 2) with limit 1.
      "`x`, called by `a`, only cases of `always` before 1",
      "`y`, called by `a`, only cases of `always` before 2",
      "`y`, called by `a`, only cases of `always` before 2, just returned to",
      "`x`, called by `y`, called by `a`, only cases of `always` before 1",
      "`x`, called by `b`, called by `a`, only cases of `always` before 1",
      "`y`, called by `b`, called by `a`, only cases of `always` before 2",
      "`y`, called by `b`, called by `a`, only cases of `always` before 2, just returned to",
      "`x`, called by `y`, called by `b`, called by `a`, only cases of `always` before 1", "`c`",
      "`c`, just returned to", "`x`, called by `c`, only cases of `always` before 1",
      "`y`, called by `c`, only cases of `always` before 2",
      "`y`, called by `c`, only cases of `always` before 2, just returned to",
      "`x`, called by `y`, called by `c`, only cases of `always` before 1"};
  EXPECT_EQ(steps.configurations(), expected);
}

TEST_F(Rules, L1AGotoByAlwaysLimitsItUntilTheNextGotoOfAState) {
  const Steps steps("always\n  case temp > 20 degC goto x\n  case temp > 10 degC goto y\n" +
                    state("a", "case true exit") + state("x", "case true goto a") +
                    state("y", "case temp > 9 degC goto y"));
  const std::set<std::string> expected{"`a`", "`x`, only cases of `always` before 1",
                                       "`y`, only cases of `always` before 2", "`y`"};
  EXPECT_EQ(steps.configurations(), expected);
}

TEST_F(Rules, AfterAReturnTheStateComesBeforeAlways) {
  const Steps steps(
      "var v : number = 0 in 0 .. 2\n"
      "always\n  case true do set v = 1 end stay\n" +
      state("a", "case temp > 20 degC call b\ncase true do set v = 2 end stay") +
      state("b", "case true return"));
  EXPECT_TRUE(steps.must("`a`", "true", "leaves no state", "(= |var v| 2.0)"));
  EXPECT_TRUE(steps.must("`a`, just returned to", "true", "leaves no state", "(= |var v| 1.0)"));
  EXPECT_TRUE(steps.must("`a`, just returned to", "(= |var v| 0.0)", "call", "(= |var v| 0.0)"));
}

TEST_F(Rules, E2E5AReturnRunsEntriesAndStartsNoVariables) {
  const std::string counting = R"(flightprofile counting
begin
  var n : number = 3 in 0 .. 9
  entry do set n = min(n + 1, 9) end
end
)";
  const Steps steps(
      counting +
      state("a", "case temp > 20 degC call b\ncase became(temp > 5 degC) stay", "counting") +
      state("b", "case statetime >= 0 s return"));
  const std::string n = "|var a.profile.n|";
  EXPECT_TRUE(steps.must("start", "true", "it", fmt::format("(= {} 4.0)", n)));
  EXPECT_TRUE(steps.must(
      "`b`, called by `a`",
      fmt::format("(and |var a.profile.n known| (= {} 7.0) (= |entered 0| 1.0))", n), "return",
      fmt::format("(and (= {} 8.0) (= |entered 0| 1.0) (= |resumed| |time|) (= |since 0| |time|))",
                  n)));
}

TEST_F(Rules, DoneSetsTheActivitysTruthValue) {
  const std::string dive = R"(flightprofile once
begin
  entry do surface() end
  events
    case temp > 20 degC done
end
)";
  const Steps steps(dive + state("a", "case profiledone exit", "once"));
  const std::string done = "|var a.profile.done true|";
  EXPECT_TRUE(steps.can("`a`", "(not " + done + ")", "leaves no state", done));
  EXPECT_TRUE(steps.can("`a`", "(not " + done + ")", "leaves no state", "(not " + done + ")"));
  EXPECT_FALSE(steps.can("`a`", done, "leaves no state", "true"));
}

TEST_F(Rules, Step5CodeInCMayCommandWheneverItIsCalled) {
  const auto mission = [](const std::string& profile, const std::string& cases) {
    Mission m = missionOf(kHeader + "behaviour profile still symbol \"\" () reads ()\n" +
                          "behaviour route straight symbol \"\" () reads ()\n" + "state a " +
                          profile + cases + "\nstate b route straight begin end profile still " +
                          "begin end case true return");
    m.requirements.emplace_back().kind = RequirementKind::ExitWithin;
    return m;
  };
  const std::string call = " case (gt missiontime 100:time) call b";
  const std::string none = "route straight begin end profile still begin end";
  for (const char* in_c :
       {"route drift () profile still begin end", "route straight begin end profile glide ()"}) {
    const Steps steps(mission(in_c, call));
    EXPECT_TRUE(steps.can("start", "true", "it", "(= |deepest| 500.0)"));
    EXPECT_TRUE(steps.can("`a`", "(< |deepest| 9.0)", "leaves no state", "(= |deepest| 500.0)"));
    EXPECT_FALSE(steps.can("`a`", "(< |deepest| 9.0)", "call", "(= |deepest| 500.0)"));
    EXPECT_TRUE(
        steps.can("`b`, called by `a`", "(< |deepest| 9.0)", "return", "(= |deepest| 500.0)"));
  }
  const Steps steps(mission(none, call));
  EXPECT_FALSE(steps.can("start", "true", "it", "(= |deepest| 500.0)"));
  EXPECT_FALSE(steps.can("`a`", "(< |deepest| 9.0)", "leaves no state", "(= |deepest| 500.0)"));
}

TEST_F(Rules, W6AWindowIsUnknownUntilItsTimeHasPassedInItsState) {
  const Steps steps(state("a", "case known(mean(temp, 60 s)) exit\ncase temp > 9 degC call b") +
                    state("b", "case true return"));
  EXPECT_FALSE(steps.can("`a`", "(and (= |time| 10.0) (= |entered 0| 0.0))", "exit", "true"));
  EXPECT_TRUE(steps.can("`a`", "(and (= |time| 50.0) (= |entered 0| 0.0))", "exit", "true"));
  EXPECT_FALSE(steps.can("`a`", "(and (= |time| 50.0) (= |entered 0| 40.0))", "exit", "true"));
  EXPECT_TRUE(steps.can("`a`, just returned to",
                        "(and (= |time| 50.0) (= |entered 0| 0.0) (= |resumed| 50.0))", "exit",
                        "true"))
      << "a return starts no window";
}

TEST_F(Rules, WhatWindowsMayBe) {
  const Steps steps(
      state("a",
            "case mean(temp, 60 s) > 46 degC exit\ncase lowest(temp, 60 s) < -5.1 degC exit\n"
            "case spread(temp, 60 s) > 50.1 degC exit\ncase highest(temp, 60 s) > 44.9 degC stay\n"
            "case rate(temp, 60 s) > 100 degC / s goto a"));
  EXPECT_FALSE(steps.can("`a`", "(= |time| 500.0)", "exit", "true"));
  EXPECT_TRUE(steps.can("`a`", "(and (= |time| 500.0) (= |entered 0| 0.0))", "goto", "true"));
}

TEST_F(Rules, N11AgesAndStaleReadings) {
  const Steps steps(state("a",
                          "case known(temp) && age(temp) > 20 s exit\n"
                          "case age(temp) > missiontime exit\n"
                          "case known(temp) && age(temp) >= 20 s goto a"));
  EXPECT_FALSE(steps.can("`a`", "true", "exit", "true"));
  EXPECT_TRUE(steps.can("`a`", "true", "goto", "true"));
}

TEST_F(Rules, Step2ReadingsAreInTheirRange) {
  const Steps steps(state("a",
                          "case temp > 45 degC exit\ncase temp < -5 degC exit\n"
                          "case temp == 45 degC goto a"));
  EXPECT_FALSE(steps.can("`a`", "true", "exit", "true"));
  EXPECT_TRUE(steps.can("`a`", "true", "goto", "true"));
  EXPECT_TRUE(steps.can("`a`", "true", "leaves no state", "true")) << "or it is unknown";
}

TEST_F(Rules, V7AReadingOfTheDepthIsNearIt) {
  const Steps steps(state("a",
                          "case depth > 10.95 m exit\ncase depth < 9.05 m exit\n"
                          "case depth > 10.85 m goto a"));
  // At once, and so where it was.
  const std::string here = "(and (= |depth| 10.0) (= |deepest| 10.0) (= |time| 0.0))";
  EXPECT_TRUE(steps.can("`a`", here, "exit", "true")) << "it may have climbed";
  EXPECT_FALSE(steps.can("`a`", here, "goto", "(> |depth| 10.0)"));
  EXPECT_TRUE(steps.can("`a`", here, "goto", "(> |depth| 9.9)"));
  EXPECT_FALSE(steps.can("`a`", here, "goto", "(< |depth| 9.9)"));
}

TEST_F(Rules, B1ToB7BecameAndHeld) {
  const Steps steps(state("a",
                          "case became(temp > 20 degC) goto b\n"
                          "case held(temp > 30 degC, 60 s) goto c") +
                    state("b", "case true exit") + state("c", "case true exit"));
  EXPECT_FALSE(steps.can("`a`", "|was 0|", "goto `b`", "true"));
  EXPECT_TRUE(steps.can("`a`", "(not |was 0|)", "goto `b`", "true"));
  EXPECT_TRUE(steps.must("`a`", "|was 0|", "goto `c`", "(>= |time| 60.0)"));
  EXPECT_TRUE(steps.can("`a`", "(and |was 0| |was 1| (= |since 1| 5.0) (= |time| 45.0))",
                        "goto `c`", "(= |time| 65.0)"));
  EXPECT_FALSE(
      steps.can("`a`", "(and |was 1| (= |since 1| 5.1) (= |time| 45.0))", "goto `c`", "true"));
  EXPECT_FALSE(steps.can("`a`", "(and (not |was 1|) (= |since 1| 5.0) (= |time| 45.0))", "goto `c`",
                         "true"));
  EXPECT_TRUE(steps.must("`a`", "(and (not |was 1|) |was 0|)", "leaves no state",
                         "(=> |was 1| (= |since 1| |time|))"));
}

TEST(Readings, D1DegreesAndMinutes) {
  Sensor s;
  s.encoding = Encoding::DegreesMinutes;
  s.lowest = -9000;
  s.highest = 7330;
  EXPECT_EQ(rangeOfReadings(s).lowest, -90);
  EXPECT_EQ(rangeOfReadings(s).highest, 73.5);
  s.highest = 7399.5;
  EXPECT_EQ(rangeOfReadings(s).highest, 74) << "60 minutes or more are unknown";
  s.encoding = Encoding::Linear;
  s.to_si = -0.1;
  EXPECT_EQ(rangeOfReadings(s).highest, 900);
}

TEST_F(Rules, B6HeldIsFalseWhileItsOperandIs) {
  const Steps steps(state("a",
                          "case !held(temp > 30 degC, 60 s) && temp <= 30 degC exit\n"
                          "case temp <= 30 degC goto a"));
  EXPECT_TRUE(steps.can("`a`", "true", "exit", "true"));
  EXPECT_FALSE(steps.can("`a`", "true", "goto", "true"));
}

TEST_F(Rules, N3N6N7N10WhatIsKnown) {
  const std::string chosen = "(select (gt (sensor depth) 5:length) (sensor temp) 7:temperature)";
  Mission mission = missionOf(
      kHeader + "behaviour profile still symbol \"\" () reads ()\n" +
      "behaviour route straight symbol \"\" () reads ()\ntable number (1, 5)\n" +
      "state a route straight begin end profile still begin end\n" +
      "case (and (le (sensor depth) 5:length) (not (known " + chosen + "))) exit\n" +
      "case (and (known " + chosen + ") (not (known (sensor depth)))) exit\n" +
      "case (and (gt (sensor depth) 5:length) (and (known " + chosen +
      ") (not (known (sensor temp))))) exit\n" +
      "case (gt (element 0 (div statetime 1:time)) 4) goto a\n" +
      "case (and (lt statetime 0.5:time) (known (element 0 (sub (div statetime 1:time) 1)))) "
      "exit\n" +
      "let %90 = (sub (div statetime 1:time) 3)\n" +
      "case (and (eq %90 0) (known (div 1 %90))) exit\n" +
      "case (and (lt %90 0) (known (sqrt %90))) exit\n" +
      "case (and (not (known (sensor temp))) (not (lt (sensor temp) 7:temperature))) exit\n" +
      "case (and (not (known (sensor temp))) (not (lt 7:temperature (sensor temp)))) exit\n");
  mission.requirements.emplace_back().kind = RequirementKind::ExitWithin;
  const Steps steps(std::move(mission));
  EXPECT_FALSE(steps.can("`a`", "(= |entered 0| 0.0)", "exit", "true"));
  EXPECT_TRUE(steps.must("`a`", "(and (= |entered 0| 0.0) (= |time| 0.0))", "goto",
                         "(and (> |time| 0.999) (< |time| 1.001))"));
}

}  // namespace
}  // namespace glider::ir::certify
