// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Assignments that only the guards before them keep in range: which are accepted, and that no run
// of one that was accepted leaves a range (the interpreter would end the program).

#include "ir/eval/interpreter.h"
#include "ir/verify/intervals.h"
#include "ir/verify/verify.h"
#include "tests/random_missions/random.h"
#include "tests/unit/ir/missions.h"

#include <fmt/format.h>

#include <limits>

namespace glider::ir {
namespace {

const std::string kCounters = kHeader + R"(function f symbol f (): number lowest -90 highest 90
use f
use f
table number (-7, 70)
table number (-7, 77)
behaviour profile yo symbol "" () reads ()
variable top: number parameter lowest 0 highest 4.5
variable n: number mission lowest 0 highest 5
variable x: length mission lowest 0 highest 50
variable other: number mission lowest -100 highest 100
variable t: time mission lowest 0 highest 50
variable odd: bool mission
variable "b.k": number argument of b
initial top 3
initial n 0
initial x 3:length
initial other 0
initial t 0:time
initial odd false
)";

std::string accepted(const std::string& text) {
  const Mission mission = missionOf(text);
  support::DiagnosticEngine diagnostics;
  verify(mission, diagnostics);
  return diagnostics.errorCount() == 0 ? "accepted" : "refused";
}

/// Of a mission whose first state has these cases.
std::string ofCases(const std::string& cases, const std::string& always = "") {
  return accepted(kCounters + always +
                  stateText("a", cases + " case (ge missiontime 9:time) exit") +
                  "state b (\"b.k\") route drift () profile glide () case true goto a\n");
}

struct GuardedRow {
  const char* verdict;
  const char* cases;
};

class GuardedRanges : public testing::TestWithParam<GuardedRow> {};

TEST_P(GuardedRanges, AreNarrowedByTheGuardsBeforeThem) {
  const std::string windows =
      "temporal mean always (sensor depth) over 10\n"
      "temporal mean always (sensor depth) over 20\n";
  EXPECT_EQ(ofCases(GetParam().cases, windows), GetParam().verdict) << GetParam().cases;
}

const GuardedRow kGuardedRows[] = {
    {"accepted", "case (lt (var n) 5) do set n (add (var n) 1) end stay"},
    {"refused", "case (le (var n) 5) do set n (add (var n) 1) end stay"},
    {"accepted", "case (le (var n) 4) do set n (add (var n) 1) end stay"},
    {"accepted", "case (gt 5 (var n)) do set n (add (var n) 1) end stay"},
    {"accepted", "case (gt (var n) 0) do set n (sub (var n) 1) end stay"},
    {"refused", "case (ge (var n) 0) do set n (sub (var n) 1) end stay"},
    {"accepted", "case (ne (var n) 5) do set n (add (var n) 1) end stay"},
    {"refused", "case (ne (var n) 4) do set n (add (var n) 1) end stay"},
    {"accepted", "case (eq (var n) 2) do set n (add (var n) 3) end stay"},
    {"refused", "case (eq (var n) 2) do set n (add (var n) 4) end stay"},
    {"accepted", "case (not (ge (var n) 5)) do set n (add (var n) 1) end stay"},
    // Of `a && b` above, `a` is known to be true here: so `b` is not.
    {"accepted",
     "case (and (gt statetime 9:time) (ge (var n) 5)) exit "
     "case (gt statetime 9:time) do set n (add (var n) 1) end goto a"},
    {"accepted",
     "case (and (gt (sensor depth) 9:length) (ge (var n) 5)) exit "
     "case (gt (sensor depth) 9:length) do set n (add (var n) 1) end goto a"},
    {"accepted",
     "case (and (gt (sensor depth) 9:length) (ge (var n) 5)) exit "
     "case (gt (sensor depth) 12:length) do set n (add (var n) 1) end goto a"},
    {"refused",
     "case (and (gt (sensor depth) 9:length) (ge (var n) 5)) exit "
     "case (gt (sensor depth) 8:length) do set n (add (var n) 1) end goto a"},
    {"refused",
     "case (and (lt (sensor depth) 9:length) (ge (var n) 5)) exit "
     "case (gt (sensor depth) 8:length) do set n (add (var n) 1) end goto a"},
    {"refused",  // the depth may be unknown
     "case (and (gt (sensor depth) 9:length) (ge (var n) 5)) exit "
     "case (gt statetime 9:time) do set n (add (var n) 1) end goto a"},
    {"refused",  // n has been set in between
     "case (and (gt statetime 9:time) (ge (var n) 4)) exit "
     "case (gt statetime 9:time) do set n (add (var n) 1) set n (add (var n) 1) "
     "set n (add (var n) 1) end goto a"},
    {"accepted",
     "case (and (gt (sensor depth) 5:length) (lt (var n) 5)) "
     "do set n (add (var n) 1) end stay"},
    {"refused",
     "case (or (gt (sensor depth) 5:length) (lt (var n) 5)) "
     "do set n (add (var n) 1) end stay"},
    {"accepted", "case (or (lt (var n) 2) (eq (var n) 3)) do set n (add (var n) 2) end stay"},
    {"accepted",
     "case (not (or (ge (var n) 5) (gt (sensor depth) 5:length))) "
     "do set n (add (var n) 1) end stay"},
    // A number that is not whole: only what is above 5 by less than 1 is left out.
    {"accepted", "case (lt (var n) (var top)) do set n (add (var n) 1) end stay"},
    {"refused",
     "case (gt (sensor depth) 5:length) do set n (mul 0.5 (var n)) end stay "
     "case (lt (var n) 5) do set n (add (var n) 1) end stay"},
    {"accepted",
     "case (lt (sensor depth) 40:length) do set x (max (sensor depth) 0:length) end stay"},
    {"refused", "case (lt (sensor depth) 40:length) do set x (sensor depth) end stay"},
    {"accepted",
     "case (and (le (mul 2 (sensor depth)) 40:length) (ge (mul 2 (sensor depth)) "
     "1:length)) do set x (mul 2 (sensor depth)) end stay"},
    // More than one in a block.
    {"refused", "case (lt (var n) 5) do set n (add (var n) 1) set n (add (var n) 1) end stay"},
    {"accepted", "case (lt (var n) 4) do set n (add (var n) 1) set n (add (var n) 1) end stay"},
    {"refused", "case (lt (var n) 5) do set n 5 set n (add (var n) 1) end stay"},
    {"accepted", "case true do set n 2 set n (add (var n) 1) end stay"},
    // An unknown value leaves what was there.
    {"refused",
     "case (gt (var n) 3) do set n (clamp (div (sensor depth) 1:length) 0 1) "
     "set n (add (var n) 1) end stay"},
    // Branches.
    {"accepted", "case true do if (lt (var n) 5) set n (add (var n) 1) end end stay"},
    {"accepted", "case true do if (ge (var n) 5) set n 0 else set n (add (var n) 1) end end stay"},
    {"refused",
     "case true do if (gt (sensor depth) 5:length) set n 0 end "
     "set n (add (var n) 1) end stay"},
    {"refused",
     "case (lt (var n) 5) do if (gt (sensor depth) 5:length) set n 5 end "
     "set n (add (var n) 1) end stay"},
    {"refused", "case true do if (lt (var n) 5) set other 1 end set n (add (var n) 1) end stay"},
    {"refused",
     "case true do if (gt (sensor depth) 5:length) set n 0 else set n 1 end "
     "set n (add (var n) 1) end stay"},
    {"accepted",
     "case (lt (var n) 2) do if (gt (sensor depth) 5:length) set n 0 else set n 1 end "
     "set n (add (var n) 1) end stay"},
    // A condition on an unknown reading is not the same as its opposite's being false.
    {"refused",
     "case true do if (gt (sensor depth) 50:length) set other 1 else set x (sub "
     "100:length (sensor depth)) end end stay"},
    // Cases above it were not true.
    {"accepted", "case (ge (var n) 5) exit case true do set n (add (var n) 1) end stay"},
    {"refused", "case (gt (var n) 5) exit case true do set n (add (var n) 1) end stay"},
    {"refused",
     "case (ge (div (var other) (var other)) (var n)) exit "
     "case true do set n (add (var n) 1) end stay"},
    {"accepted", "case (and (ge (var n) 5) true) stay case true do set n (add (var n) 1) end stay"},
    {"refused",
     "case (and (ge (var n) 5) (gt (sensor depth) 5:length)) stay "
     "case true do set n (add (var n) 1) end stay"},
    {"accepted",
     "case (or (ge (var n) 5) (gt (sensor depth) 5:length)) stay "
     "case true do set n (add (var n) 1) end stay"},
    // What is said of one expression says nothing of another that is like it.
    {"refused", "case (le (add (var n) 1) 5) do set n (add (var n) 4) end stay"},
    {"accepted", "case (le (add (var n) 1) 5) do set n (add (var n) 1) end stay"},
    {"refused",
     "case (and (ge (var other) 0) (lt (var other) 5)) do set n (add (var n) 1) end stay"},
    {"refused",
     "case (and (ge (div (sensor depth) 1:length) 0) (le (div (sensor depth) 1:length) 5)) "
     "do set n (div (sensor temp) 1:temperature) end stay"},
    {"accepted",
     "case (and (ge (div (sensor depth) 1:length) 0) (le (div (sensor depth) 1:length) 5)) "
     "do set n (div (sensor depth) 1:length) end stay"},
    {"refused",
     "case (and (ge (element 0 (var other)) 0) (le (element 0 (var other)) 5)) "
     "do set n (element 1 (var other)) end stay"},
    {"accepted",
     "case (and (ge (element 0 (var other)) 0) (le (element 0 (var other)) 5)) "
     "do set n (element 0 (var other)) end stay"},
    {"refused",
     "case (and (ge (temporal 0) 0:length) (le (temporal 0) 5:length)) "
     "do set x (temporal 1) end stay"},
    {"accepted",
     "case (and (ge (temporal 0) 0:length) (le (temporal 0) 5:length)) "
     "do set x (temporal 0) end stay"},
    {"refused", "case (and (ge (call 0) 0) (le (call 0) 5)) do set n (call 1) end stay"},
    {"accepted", "case (and (ge (call 0) 0) (le (call 0) 5)) do set n (call 0) end stay"},
    // Ends that are left out, from both sides.
    {"accepted",
     "case (and (ge (var other) 0) (lt (var other) 5.5)) do set n (var other) end stay"},
    {"accepted", "case (and (le 0 (var other)) (ge 5 (var other))) do set n (var other) end stay"},
    {"refused", "case (and (lt -2 (var other)) (ge 5 (var other))) do set n (var other) end stay"},
    {"refused", "case (and (le 0 (var other)) (gt 7 (var other))) do set n (var other) end stay"},
    {"accepted", "case (gt 5 (add (var n) 0)) do set n (add (var n) 0) end stay"},
    {"accepted", "case (lt 0 (var n)) do set n (sub (var n) 1) end stay"},
    {"refused", "case (le 0 (var n)) do set n (sub (var n) 1) end stay"},
    {"accepted", "case (ne 0 (var n)) do set n (sub (var n) 1) end stay"},
    {"refused", "case (ne 1 (var n)) do set n (sub (var n) 1) end stay"},
    {"refused", "case (ne (var n) (var top)) do set n (add (var n) 1) end stay"},
    // Of two sides that were not compared so, one may have been unknown.
    {"accepted", "case (le 5 (var n)) exit case true do set n (add (var n) 1) end stay"},
    {"accepted",
     "case (ge missiontime (var t)) exit case true do set t (sub (var t) 1:time) end stay"},
    {"accepted",
     "case (ge statetime (var t)) exit case true do set t (sub (var t) 1:time) end stay"},
    {"accepted",
     "case (le (var t) resumetime) exit case true do set t (sub (var t) 1:time) end stay"},
    {"refused",
     "case (gt missiontime (var t)) exit case true do set t (sub (var t) 1:time) end stay"},
    {"refused",
     "case (ge (age depth) (var t)) exit case true do set t (sub (var t) 1:time) end stay"},
    {"accepted", "case (ge (var n) (var top)) exit case true do set n (add (var n) 1) end stay"},
    {"refused", "case (gt (var n) 3) do set n (mul 1e300 1e300) set n (add (var n) 1) end stay"},
    // What never fires sets nothing.
    {"accepted", "case (gt (var n) 10) do set n 1000 end stay"},
    {"accepted",
     "case (and (var odd) (lt (var n) 5)) do set odd false set n (add (var n) 1) end stay"},
};

INSTANTIATE_TEST_SUITE_P(Rows, GuardedRanges, testing::ValuesIn(kGuardedRows));

TEST(GuardedRangesTest, WhatNestsTooDeepSaysNothing) {
  const auto nested = [](const std::string& before, const std::string& after, int depth) {
    std::string text = "(lt (var n) 5)";
    for (int i = 0; i < depth; ++i) {
      text = before + text + after;
    }
    return ofCases("case " + text + " do set n (add (var n) 1) end stay");
  };
  EXPECT_EQ(nested("(and true ", ")", 100), "accepted");
  EXPECT_EQ(nested("(and true ", ")", 101), "refused");
  EXPECT_EQ(nested("(and ", " true)", 100), "accepted");
  EXPECT_EQ(nested("(and ", " true)", 101), "refused");
  EXPECT_EQ(nested("(or false ", ")", 100), "accepted");
  EXPECT_EQ(nested("(or false ", ")", 101), "refused");
  EXPECT_EQ(nested("(or ", " false)", 100), "accepted");
  EXPECT_EQ(nested("(or ", " false)", 101), "refused");
  EXPECT_EQ(nested("(not ", ")", 100), "accepted");
  EXPECT_EQ(nested("(not ", ")", 102), "refused");
}

TEST(GuardedRangesTest, ArgumentsAreGuardedToo) {
  const auto ofArgument = [](const std::string& guarded) {
    return accepted(kHeader + "variable \"b.k\": number argument of b lowest 0 highest 3\n" +
                    stateText("a", "case true goto b (0)") +
                    "state b (\"b.k\") route drift () profile glide () " + guarded +
                    " goto b ((add (var \"b.k\") 1)) case true goto a\n");
  };
  EXPECT_EQ(ofArgument("case (lt (var \"b.k\") 3)"), "accepted");
  EXPECT_EQ(ofArgument("case (lt (var \"b.k\") 4)"), "refused");
}

TEST(GuardedRangesTest, ArgumentsComeAfterTheBlock) {
  EXPECT_EQ(accepted(kCounters +
                     stateText("a",
                               "case (lt (var n) 5) do set n 5 end "
                               "goto c ((add (var n) 1))") +
                     "variable \"c.k\": number argument of c lowest 0 highest 5\n" +
                     "state c (\"c.k\") route drift () profile glide () case true exit\n"
                     "state b (\"b.k\") route drift () profile glide () case true exit\n"),
            "refused");
}

TEST(GuardedRangesTest, ACaseOfAlwaysMayBePassedOver) {
  const std::string counts = "case true do set n (add (var n) 1) end stay\n";
  EXPECT_EQ(ofCases("case true stay", "always case (ge (var n) 5) call a " + counts), "refused")
      << "`a` may be current";
  EXPECT_EQ(ofCases("case true stay", "always case (ge (var n) 5) exit " + counts), "accepted");
}

TEST(GuardedRangesTest, ListsAreTriedOneAfterTheOther) {
  // The first list's block has run before the second list's guard is asked.
  EXPECT_EQ(ofCases("case (lt (var n) 5) do set n (add (var n) 1) end stay",
                    "always case (lt (var n) 5) do set n (add (var n) 1) end stay\n"),
            "accepted");
}

TEST(GuardedRangesTest, WhatIsHeldSaysNothingOfNow) {
  EXPECT_EQ(accepted(kCounters + "temporal held state a (lt (var n) 5) for 8:time\n" +
                     "always case (lt (var n) 5) do set n (add (var n) 1) end stay\n" +
                     stateText("a", "case (temporal 0) do set n (add (var n) 1) end stay") +
                     "state b (\"b.k\") route drift () profile glide () case true exit\n"),
            "refused");
}

TEST(GuardedRangesTest, AWindowHoldsWhatWasBefore) {
  EXPECT_EQ(accepted(kCounters + "temporal highest state a (var n) over 100\n" +
                     stateText("a",
                               "case (lt (var n) 3) do set n (min (temporal 0) 5) "
                               "set other (mul 50 (temporal 0)) end stay") +
                     "state b (\"b.k\") route drift () profile glide () case true exit\n"),
            "refused")
      << "50 times 5 is beyond 100";
}

TEST(GuardedRangesTest, EntriesHaveNoGuard) {
  EXPECT_EQ(accepted(kCounters + stateText("a", "case (lt (var n) 5) goto b (1)") +
                     "state b (\"b.k\") route drift () profile glide () "
                     "entry do set n (add (var n) 1) end case true goto b (1)\n"),
            "refused");
}

/// A text with conditions and assignments at random about small numbers.
class RandomCounters {
 public:
  explicit RandomCounters(uint64_t seed) : random_(seed) {}

  std::string text() {
    std::string cases, always;
    for (uint64_t i = 0; i < 1 + random_.below(3); ++i) {
      cases += fmt::format("case {} do {} end {} ", condition(2), block(2),
                           random_.below(3) == 0 ? "goto a" : "stay");
    }
    if (random_.below(2) == 0) {
      always = fmt::format("always case {} do {} end stay\n", condition(2), block(1));
    }
    return kHeader + R"(variable p: number parameter lowest 0 highest 3.5
variable n: number mission lowest 0 highest 4
variable m: number mission lowest -2 highest 6
initial p 2
initial n 0
initial m 1
)" + always +
           stateText("a", cases + "case (ge missiontime 1000:time) exit");
  }

 private:
  std::string leaf() {
    switch (random_.below(5)) {
      case 0:
        return "(var n)";
      case 1:
        return "(var m)";
      case 2:
        return "(var p)";
      case 3:
        return "(div (sensor depth) 1:length)";
      default:
        return std::to_string(random_.below(6));
    }
  }
  std::string number() {
    switch (random_.below(5)) {
      case 0:
        return fmt::format("(add {} {})", leaf(), leaf());
      case 1:
        return fmt::format("(sub {} {})", leaf(), leaf());
      case 2:
        return fmt::format("(min {} {})", leaf(), leaf());
      default:
        return leaf();
    }
  }
  std::string condition(unsigned depth) {  // NOLINT(misc-no-recursion): no deeper than `depth`
    const char* const ops[] = {"lt", "le", "gt", "ge", "eq", "ne"};
    switch (depth == 0 ? 5 : random_.below(6)) {
      case 0:
        return fmt::format("(and {} {})", condition(depth - 1), condition(depth - 1));
      case 1:
        return fmt::format("(or {} {})", condition(depth - 1), condition(depth - 1));
      case 2:
        return fmt::format("(not {})", condition(depth - 1));
      default:
        return fmt::format("({} {} {})", ops[random_.below(6)], number(), number());
    }
  }
  std::string block(unsigned depth) {  // NOLINT(misc-no-recursion): no deeper than `depth`
    std::string all;
    for (uint64_t i = 0; i < 1 + random_.below(2); ++i) {
      if (depth > 0 && random_.below(3) == 0) {
        all +=
            fmt::format("if {} {} else {} end ", condition(1), block(depth - 1), block(depth - 1));
      } else {
        const char* counts = random_.below(2) == 0 ? "n" : "m";
        all += random_.below(2) == 0
                   ? fmt::format("set {0} ({1} (var {0}) {2}) ", counts,
                                 random_.below(2) == 0 ? "add" : "sub", 1 + random_.below(2))
                   : fmt::format("set {} {} ", counts, number());
      }
    }
    return all;
  }

  random_missions::Random random_;
};

/// Whether every assignment fits if the guards are ignored.
bool fitsPlainly(const Mission& m) {
  const std::vector<Interval> intervals = intervalsOf(m);
  for (const Block& block : m.blocks) {
    for (const Statement& s : block.statements) {
      if (s.kind == StatementKind::Set &&
          !intervals[s.value.index].within(m[s.variable].lowest, m[s.variable].highest)) {
        return false;
      }
    }
  }
  return true;
}

TEST(GuardedRangesTest, NoRunOfWhatIsAcceptedLeavesARange) {
  size_t by_guards = 0;
  for (uint64_t seed = 1; seed <= 4000; ++seed) {
    const Mission mission = missionOf(RandomCounters(seed).text());
    support::DiagnosticEngine diagnostics;
    const MissionFacts facts = verify(mission, diagnostics);
    if (diagnostics.errorCount() != 0 || fitsPlainly(mission)) {
      continue;
    }
    ++by_guards;
    for (uint64_t flight = 0; flight < 4; ++flight) {
      random_missions::Random random(seed * 4 + flight);
      Interpreter run(mission, facts.stack_depth);
      const double top = 0.5 * static_cast<double>(random.below(8));
      (void)run.start({}, std::vector<double>{top});
      for (int i = 1; i < 40; ++i) {
        std::vector<SensorUpdate> frame;
        if (random.below(3) != 0) {
          frame.push_back({{0}, 0.5 * static_cast<double>(random.below(14)) - 1});
        } else {
          frame.push_back({{0}, std::numeric_limits<double>::quiet_NaN()});
        }
        const TickResult left = run.tick(4.0 * i, frame);  // ends the program where it leaves one
        EXPECT_TRUE(left.variables[1] >= 0 && left.variables[1] <= 4);
      }
    }
  }
  EXPECT_GT(by_guards, 40U) << "too few are kept by their guards";
}

}  // namespace
}  // namespace glider::ir
