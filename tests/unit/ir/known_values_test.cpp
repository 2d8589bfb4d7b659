// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What proofs take for granted of single expressions: that they are never unknown, that they are
// whole, that the commands keep the depth they speak of.

#include "ir/prove/abstract/depth_bound.h"
#include "ir/prove/abstract/state_depths.h"
#include "ir/prove/context/never_unknown.h"
#include "ir/verify/whole_numbers.h"
#include "tests/unit/ir/missions.h"
#include "tests/unit/ir/slocum.h"

#include <algorithm>
#include <cmath>

namespace glider::ir::prove {
namespace {

const std::string kVariables = R"(table number (7, 8)
table number (7, 9)
variable up: number parameter lowest 1 highest 4.5
variable down: number parameter lowest -4 highest -1
variable from0: number parameter lowest 0 highest 4
variable to0: number parameter lowest -4 highest 0
variable n: number mission lowest 0 highest 5
variable set: number mission lowest -inf highest inf
variable big: number mission lowest -9007199254740992 highest 5
variable biggest: number mission lowest 0 highest 9007199254740991
variable half: number mission lowest 0 highest 5
variable odd: bool mission
initial up 3
initial down -3
initial from0 3
initial to0 -3
initial n 0
initial set 0
initial big 0
initial biggest 0
initial half 0.5
initial odd false
temporal became always (gt (sensor depth) 5:length)
)";

/// The mission that logs a number, or has a condition in a guard.
Mission missionWith(const std::string& number, const std::string& condition) {
  return missionOf(kHeader + kVariables +
                   "state a route drift () profile glide () entry do log \"r\" (" + number +
                   ") end case " + condition + " stay\n");
}
ExprId loggedIn(const Mission& m) {
  return m.blocks.at(0).statements.at(0).values.at(0);
}

bool isNumberKnown(const std::string& text) {
  const Mission m = missionWith(text, "true");
  return neverUnknown(m, intervalsOf(m)).expressions.at(loggedIn(m).index);
}
bool isConditionKnown(const std::string& text) {
  const Mission m = missionWith("1", text);
  return neverUnknown(m, intervalsOf(m)).expressions.at(m.states[0].cases.at(0).guard.index);
}

TEST(NeverUnknown, NumbersThatAreMadeOfKnownOnes) {
  for (const char* known : {"5",
                            "missiontime",
                            "statetime",
                            "resumetime",
                            "(age depth)",
                            "(var up)",
                            "(var n)",
                            "(neg (var up))",
                            "(abs (var up))",
                            "(min (var up) 1)",
                            "(max (var up) 1)",
                            "(clamp (var up) 1 2)",
                            "(select (gt (var up) 2) (var up) 1)",
                            "(select (known (sensor depth)) (sensor depth) 1:length)",
                            "(add (var up) 1)",
                            "(sub (var up) 1)",
                            "(mul (var up) 2)",
                            "(div 1 (var up))",
                            "(div 1 (var down))",
                            "(mul 2e299 (var up))",
                            "(mul -2e299 (var up))",
                            "(element 0 1)",
                            "(element 0 (min (var n) 1))"}) {
    EXPECT_TRUE(isNumberKnown(known)) << known;
  }
}

TEST(NeverUnknown, NumbersThatMayBe) {
  for (const char* unknown : {"(sensor depth)",
                              "(neg (sensor depth))",
                              "(abs (sensor depth))",
                              "(min (sensor depth) 1:length)",
                              "(max 1:length (sensor depth))",
                              "(clamp 1:length 0:length (sensor depth))",
                              "(select (gt (var up) 2) (sensor depth) 1:length)",
                              "(select (gt (sensor depth) 2:length) 1 2)",
                              "(select (known (sensor depth)) 1:length (sensor depth))",
                              "(select (known (sensor temp)) (sensor depth) 1:length)",
                              "(select (not (known (sensor depth))) (sensor depth) 1:length)",
                              "(select (known (sensor depth)) (sensor depth) (abs (sensor depth)))",
                              "(add (sensor depth) 1:length)",
                              "(sub 1:length (sensor depth))",
                              "(mul 2 (sensor depth))",
                              "(div (sensor depth) 2)",
                              "(div 1 (var from0))",
                              "(div 1 (var to0))",
                              "(div 1 (sub (var up) 2))",
                              "(sqrt (var up))",
                              "(element 0 (var n))",
                              "(element 0 (sub (min (var n) 1) 1))",
                              "(element 0 (min (var half) 1))",
                              "(element 0 (min (sub (var up) 1) 1))",
                              "(mul 1e300 (var up))",
                              "(mul -1e300 (var up))",
                              "(mul 1e300 1)",
                              "(mul 1e300 (var from0))",
                              "(mul 1e300 (var to0))",
                              "(mul 1e300 1e300)",
                              "(add 1e300 0)",
                              "(sub 0 1e300)",
                              "(div 1e300 1)"}) {
    EXPECT_FALSE(isNumberKnown(unknown)) << unknown;
  }
}

TEST(NeverUnknown, Conditions) {
  for (const char* known :
       {"true", "false", "(known (sensor depth))", "(gt (var up) 2)", "(not (gt (var up) 2))",
        "(var odd)", "(or (gt (var up) 2) true)", "(and (gt (var up) 2) true)",
        "(and (known (sensor depth)) (gt (sensor depth) 5:length))",
        "(and (known (sensor depth)) (lt 5:length (sensor depth)))"}) {
    EXPECT_TRUE(isConditionKnown(known)) << known;
  }
  for (const char* unknown :
       {"(gt (sensor depth) 5:length)", "(temporal 0)", "(not (gt (sensor depth) 5:length))",
        "(or (known (sensor depth)) (gt (sensor depth) 5:length))",
        "(or true (gt (sensor depth) 5:length))", "(and (gt (sensor depth) 5:length) true)",
        "(and true (gt (sensor depth) 5:length))",
        "(and (known (sensor depth)) (gt (sensor temp) 5:temperature))",
        "(and (known (sensor depth)) (gt (sensor depth) (mul (sensor temp) (div 1:length "
        "1:temperature))))",
        "(and (known (sensor depth)) (gt (mul (sensor temp) (div 1:length 1:temperature)) (sensor "
        "depth)))",
        "(and (known (add (sensor depth) 1:length)) (gt (sensor depth) 5:length))",
        "(and (known (sensor depth)) (not (gt (sensor depth) 5:length)))",
        "(and (gt (sensor depth) 5:length) (known (sensor depth)))",
        "(and (not (known (sensor depth))) (gt (sensor depth) 5:length))"}) {
    EXPECT_FALSE(isConditionKnown(unknown)) << unknown;
  }
}

TEST(NeverUnknown, VariablesThatBeginKnown) {
  const Mission m = missionOf(
      kHeader +
      "variable top: length parameter lowest 1 highest 4.5\n"
      "variable \"b.given\": length argument of b\n"
      "variable \"b.kept\": length state of b\n"
      "variable \"b.measured\": length state of b\n"
      "variable mixed: length mission\n"
      "initial top 3:length\n"
      "initial \"b.kept\" (add (var \"b.given\") (var top))\n"
      "initial \"b.measured\" (sensor depth)\n"
      "initial mixed 1:length\n" +
      stateText("a", "case true do set mixed (sensor depth) end goto b ((sensor depth))") +
      "state b (\"b.given\") route drift () profile glide () case true exit\n");
  EXPECT_EQ(neverUnknown(m, intervalsOf(m)).variables,
            (std::vector<bool>{true, false, false, false, true}))
      << "what is set to an unknown value stays as it was";
  const Mission known =
      missionOf(kHeader +
                "variable \"b.given\": length argument of b\n"
                "variable \"b.kept\": length state of b\n"
                "initial \"b.kept\" (var \"b.given\")\n" +
                stateText("a", "case true goto b (7:length)") +
                "state b (\"b.given\") route drift () profile glide () case true exit\n");
  EXPECT_EQ(neverUnknown(known, intervalsOf(known)).variables, (std::vector<bool>{true, true}));
}

TEST(KnownWhere, AKnownExpressionMakesOnlyEqualOnesKnown) {
  // The condition shows the logged number, or another.
  const auto shows = [](const std::string& shown, const std::string& number) {
    const Mission m = missionWith(number, "(known " + shown + ")");
    const std::vector<Interval> intervals = intervalsOf(m);
    const ExprId asked = m[m.states[0].cases.at(0).guard].operands[0];
    return static_cast<bool>(
        knownWhere(m, intervals, neverUnknown(m, intervals), {asked}).at(loggedIn(m).index));
  };
  EXPECT_TRUE(shows("(sensor depth)", "(sensor depth)"));
  EXPECT_TRUE(shows("(sensor depth)", "(add (sensor depth) 1:length)"));
  EXPECT_TRUE(shows("(add (sensor depth) 1:length)", "(add (sensor depth) 1:length)"));
  EXPECT_TRUE(shows("(element 0 (var n))", "(element 0 (var n))"));
  EXPECT_TRUE(shows("(sensor depth)", "(var up)")) << "that is known anyway";
  EXPECT_FALSE(shows("(sensor depth)", "(sensor temp)"));
  EXPECT_FALSE(shows("(add (sensor depth) 1:length)", "(sensor depth)"));
  EXPECT_FALSE(shows("(add (sensor depth) 1:length)", "(add (sensor depth) 2:length)"));
  EXPECT_FALSE(shows("(add (sensor depth) 1:length)", "(sub (sensor depth) 1:length)"));
  EXPECT_FALSE(shows("(mul (sensor depth) (var up))", "(mul (sensor depth) (var n))"));
  EXPECT_FALSE(shows("(element 0 (var n))", "(element 1 (var n))"));
  EXPECT_FALSE(shows("(element 0 (var n))", "(element 0 (var up))"));
}

TEST(WholeExpressions, AreThoseThatNothingRounds) {
  const auto whole = [](const std::string& text) {
    const Mission m = missionWith(text, "true");
    return static_cast<bool>(wholeExpressions(m, intervalsOf(m)).at(loggedIn(m).index));
  };
  for (const char* yes :
       {"5", "-5", "0", "9007199254740991", "-9007199254740991", "(var n)", "(var biggest)",
        "(neg (var n))", "(abs (var n))", "(add (var n) 1)", "(sub (var n) 1)", "(mul (var n) 3)",
        "(min (var n) 2)", "(max (var n) 2)", "(clamp (var n) 1 2)",
        "(select (gt (sensor depth) 5:length) (var n) 1)"}) {
    EXPECT_TRUE(whole(yes)) << yes;
  }
  for (const char* no : {"0.5",
                         "9007199254740992",
                         "-9007199254740992",
                         "(var up)",
                         "(var half)",
                         "(var big)",
                         "(var set)",
                         "(add (var biggest) 1)",
                         "(sub -1 (var biggest))",
                         "(neg (var half))",
                         "(abs (var half))",
                         "(add (var n) 0.5)",
                         "(sub 0.5 (var n))",
                         "(mul (var n) 0.5)",
                         "(min (var n) (var half))",
                         "(max (var half) (var n))",
                         "(clamp (var half) 1 2)",
                         "(clamp (var n) 1 (var half))",
                         "(select (gt (var n) 2) (var half) 1)",
                         "(select (gt (var n) 2) 1 (var half))",
                         "(div (var n) 1)",
                         "missiontime",
                         "(sensor depth)"}) {
    EXPECT_FALSE(whole(no)) << no;
  }
}

/// A profile that commands 20 m, which the vehicle overshoots by 5 m.
bool isHeld(const std::string& condition) {
  const Mission m =
      missionOf(kHeader + "behaviour profile down symbol \"\" () reads ()\n" +
                "behaviour route way symbol \"\" () reads ()\n" +
                "state a route way begin entry do drift () end end profile down begin "
                "entry do descend (20:length, 0.4:angle) end end case " +
                condition + " stay\n");
  const ProofContext proof_context(m, slocum());
  return heldByCommands(m.states[0].cases.at(0).guard, proof_context,
                        std::ranges::max(deepestByState(proof_context)));
}

TEST(HeldByCommands, ALimitBelowAllCommandedDepthsIsProved) {
  for (const char* held : {"(le (sensor depth) 25:length)", "(lt (sensor depth) 25.1:length)",
                           "(ge 25:length (sensor depth))", "(gt 25.1:length (sensor depth))",
                           "(and (le (sensor depth) 25:length) (le (sensor depth) 26:length))",
                           "(or (le (sensor depth) 25:length) (le (sensor depth) 2:length))",
                           "(or (le (sensor depth) 2:length) (le (sensor depth) 25:length))",
                           "(le (sensor depth) (max 25:length (sensor depth)))"}) {
    EXPECT_TRUE(isHeld(held)) << held;
  }
  const std::string unknown = "(mul (mul 1e300 1e300) 30:length)", warm = "(sensor temp)";
  for (const std::string& broken :
       {std::string("(le (sensor depth) 24.9:length)"),
        std::string("(lt (sensor depth) 25:length)"),
        std::string("(ge 24.9:length (sensor depth))"),
        std::string("(gt 25:length (sensor depth))"),
        std::string("(ge (sensor depth) 90:length)"),
        std::string("(gt (sensor depth) 90:length)"),
        std::string("(le 90:length (sensor depth))"),
        std::string("(lt 90:length (sensor depth))"),
        std::string("(eq (sensor depth) 90:length)"),
        std::string("(ne (sensor depth) 90:length)"),
        std::string("(and (le (sensor depth) 25:length) (le (sensor depth) 2:length))"),
        std::string("(and (le (sensor depth) 2:length) (le (sensor depth) 25:length))"),
        std::string("(or (le (sensor depth) 2:length) (le (sensor depth) 3:length))"),
        std::string("(le (sensor depth) (min 25:length (sensor depth)))"),
        std::string("(le (add (sensor depth) 1:length) 90:length)"),
        std::string("(le 1:length 90:length)"),
        "(le " + warm + " 90:temperature)",
        "(lt " + warm + " 90:temperature)",
        "(ge 90:temperature " + warm + ")",
        "(gt 90:temperature " + warm + ")",
        "(le (sensor depth) " + unknown + ")",
        "(lt (sensor depth) " + unknown + ")",
        "(ge " + unknown + " (sensor depth))",
        "(gt " + unknown + " (sensor depth))",
        std::string("(not (gt (sensor depth) 90:length))")}) {
    EXPECT_FALSE(isHeld(broken)) << broken;
  }
}

/// How deep each state may be, of states that the vehicle's own behaviours fly.
std::vector<double> depthsOf(const std::vector<std::pair<std::string, std::string>>& states,
                             const std::string& always = "") {
  std::string text = kHeader + "behaviour profile vertical symbol \"\" () reads ()\n" +
                     "behaviour route way symbol \"\" () reads ()\n" + always;
  char name = 'a';
  for (const auto& [command, cases] : states) {
    text += std::string("state ") + name++ + " route way begin end profile vertical begin " +
            (command.empty() ? "" : "entry do " + command + " end ") + "end " + cases + "\n";
  }
  const Mission m = missionOf(text);
  return deepestByState(ProofContext(m, slocum()));
}

using Depths = std::vector<double>;

TEST(StateDepths, AreThoseOfTheCommands) {
  EXPECT_EQ(depthsOf({{"", "case true exit"}}), Depths{8}) << "where control is given, and 5 m";
  EXPECT_EQ(depthsOf({{"descend (20:length, 0.4:angle)", "case true exit"}}), Depths{25});
  EXPECT_EQ(depthsOf({{"ascend (20:length, 0.4:angle)", "case true exit"}}), Depths{25});
  EXPECT_EQ(depthsOf({{"hover (20:length)", "case true exit"}}), Depths{25});
  EXPECT_EQ(depthsOf({{"hover (2:length)", "case true exit"}}), Depths{8});
  EXPECT_EQ(depthsOf({{"surface ()", "case true exit"}}), Depths{8});
  EXPECT_EQ(depthsOf({{"hover (20:length) hover (30:length) hover (10:length)", "case true exit"}}),
            Depths{35});
  EXPECT_EQ(depthsOf({{"hover ((clamp (sensor depth) 0:length 12:length))", "case true exit"}}),
            Depths{17});
  EXPECT_EQ(depthsOf({{"hover ((mul 1e300 1:length))", "case true exit"}}), Depths{HUGE_VAL});
  EXPECT_EQ(depthsOf({{"hover ((mul (mul 1e300 1e300) 1:length))", "case true exit"}}), Depths{8})
      << "it is never known, and refused";
}

/// The prover adds in exact numbers: a bound that is one rounding too low allows no flight at all.
TEST(StateDepths, AreNoLessThanTheExactSum) {
  const platforms::Platform vehicle = slocum();
  const double hold = vehicle.world.climb_hold_m + vehicle.envelope.inflection_overshoot_m;
  for (const auto& [command, below] :
       {std::pair("descend", vehicle.envelope.inflection_overshoot_m), std::pair("ascend", hold)}) {
    for (int tenths = 50; tenths < 2000; tenths += 3) {
      const std::string depth = fmt::format("{}.{}", tenths / 10, tenths % 10);
      const long double exact = static_cast<long double>(std::stod(depth)) + below;
      const double found =
          depthsOf({{fmt::format("{} ({}:length, 0.4:angle)", command, depth), "case true exit"}})
              .at(0);
      EXPECT_GE(static_cast<long double>(found), exact) << command << " " << depth;
      EXPECT_LE(static_cast<long double>(found), exact + 1e-12L) << command << " " << depth;
    }
  }
}

TEST(StateDepths, GoOnWhereAStateLeads) {
  const std::string deep = "hover (50:length)", flat = "hover (20:length)";
  EXPECT_EQ(depthsOf({{deep, "case true goto b"}, {flat, "case true exit"}}), (Depths{55, 55}));
  EXPECT_EQ(depthsOf({{flat, "case true goto b"}, {deep, "case true exit"}}), (Depths{25, 55}));
  EXPECT_EQ(depthsOf({{flat, "case true call b case true exit"}, {deep, "case true return"}}),
            (Depths{55, 55}))
      << "it comes back from there";
  EXPECT_EQ(
      depthsOf(
          {{flat, "case true goto b"}, {flat, "case true call c"}, {deep, "case true return"}}),
      (Depths{25, 55, 55}))
      << "only to who calls";
  EXPECT_EQ(depthsOf({{flat, "case true call b case true exit"}, {deep, "case true exit"}}),
            (Depths{25, 55}))
      << "it does not come back";
  EXPECT_EQ(depthsOf({{deep, "case true exit"}, {flat, "case true exit"}},
                     "always case (gt (sensor depth) 9:length) goto b\n"),
            (Depths{55, 55}));
  EXPECT_EQ(depthsOf({{deep, "case true exit"}, {flat, "case true return"}},
                     "always case (gt (sensor depth) 9:length) call b\n"),
            (Depths{55, 55}));
}

}  // namespace
}  // namespace glider::ir::prove
