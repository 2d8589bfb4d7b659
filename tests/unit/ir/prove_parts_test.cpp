// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The parts that proofs are made of, each on missions so small that the answer can be written down.

#include "ir/prove/abstract/abstract_evaluator.h"
#include "ir/prove/abstract/earliest_entry.h"
#include "ir/prove/abstract/entered_after.h"
#include "ir/prove/abstract/leaving.h"
#include "ir/prove/encoding/cone_of_influence.h"
#include "ir/prove/encoding/known_roughly.h"
#include "tests/unit/ir/missions.h"
#include "tests/unit/ir/slocum.h"

#include <limits>
#include <map>

namespace glider::ir::prove {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr double kMost = std::numeric_limits<double>::max();

// --- AbstractEvaluator

/// "TFU": what a condition may be where mission time is 10 to 20 s, state time up to 10 s, resume
/// time up to 5 s.
std::string truthsOf(const std::string& condition) {
  const Mission m = missionOf(kHeader + "variable odd: bool mission\ninitial odd false\n" +
                              stateText("a", "case " + condition + " stay"));
  const ProofContext proof_context(m, slocum());
  Valuation values = {anything(m.variables[0])};
  values[0].truths = {true, false, true};
  const AbstractEvaluator now(proof_context, values,
                              {{10, 20, false}, {0, 10, false}, {0, 5, false}});
  const Truths& may = now.truth(m.states[0].cases.at(0).guard);
  return std::string(may.is_true ? "T" : "") + (may.is_false ? "F" : "") +
         (may.is_unknown ? "U" : "");
}

TEST(AbstractEvaluator, ComparisonsOfRanges) {
  const std::pair<const char*, const char*> rows[] = {
      {"(lt missiontime 10:time)", "F"},
      {"(lt missiontime 10.5:time)", "TF"},
      {"(lt missiontime 20:time)", "TF"},
      {"(lt missiontime 20.5:time)", "T"},
      {"(le missiontime 9.5:time)", "F"},
      {"(le missiontime 10:time)", "TF"},
      {"(le missiontime 19.5:time)", "TF"},
      {"(le missiontime 20:time)", "T"},
      {"(gt missiontime 20:time)", "F"},
      {"(gt missiontime 19.5:time)", "TF"},
      {"(gt missiontime 10:time)", "TF"},
      {"(gt missiontime 9.5:time)", "T"},
      {"(ge missiontime 20.5:time)", "F"},
      {"(ge missiontime 20:time)", "TF"},
      {"(ge missiontime 10.5:time)", "TF"},
      {"(ge missiontime 10:time)", "T"},
      {"(le statetime 10:time)", "T"},
      {"(le statetime 9:time)", "TF"},
      {"(le resumetime 5:time)", "T"},
      {"(le resumetime 4:time)", "TF"},
      {"(eq missiontime 10:time)", "TF"},
      {"(ne missiontime 10:time)", "TF"},
      {"(eq missiontime 90:time)", "TF"},
      {"(gt (sensor depth) 5:length)", "TFU"},
      {"(gt 5:length (sensor depth))", "TFU"},
      {"(gt (sensor depth) 100:length)", "FU"},
      {"(lt (sensor depth) 101:length)", "TU"},
      {"(lt 101:length (sensor depth))", "FU"},
      {"(gt (mul 1e300 1e300) 5)", "U"},
      {"(lt 5 (mul 1e300 1e300))", "U"},
      {"(known (sensor depth))", "TF"},
      {"(known missiontime)", "T"},
      {"true", "T"},
      {"false", "F"},
      {"(var odd)", "T"},  // it is never set, and so never unknown
  };
  for (const auto& [condition, truths] : rows) {
    EXPECT_EQ(truthsOf(condition), truths) << condition;
  }
}

TEST(AbstractEvaluator, ConditionsOfConditions) {
  const std::map<std::string, std::string> parts = {
      {"T", "true"},
      {"F", "false"},
      {"U", "(gt (mul 1e300 1e300) 5)"},
      {"TF", "(lt missiontime 15:time)"},
      {"TU", "(lt (sensor depth) 101:length)"},
      {"FU", "(gt (sensor depth) 100:length)"},
      {"TFU", "(gt (sensor depth) 5:length)"},
  };
  // By Kleene: what comes out of each that the one may be and each that the other may be.
  const auto combined = [](const std::string& a, const std::string& b, char ruling, char weak) {
    std::string out;
    for (const char wanted : {'T', 'F', 'U'}) {
      bool may = false;
      for (const char x : a) {
        for (const char y : b) {
          const char is = x == ruling || y == ruling ? ruling : x == 'U' || y == 'U' ? 'U' : weak;
          may = may || is == wanted;
        }
      }
      out += may ? std::string(1, wanted) : "";
    }
    return out;
  };
  for (const auto& [a, text_a] : parts) {
    for (const auto& [b, text_b] : parts) {
      EXPECT_EQ(truthsOf("(and " + text_a + " " + text_b + ")"), combined(a, b, 'F', 'T'))
          << a << b;
      EXPECT_EQ(truthsOf("(or " + text_a + " " + text_b + ")"), combined(a, b, 'T', 'F')) << a << b;
    }
    std::string turned;
    for (const char wanted : {'F', 'T', 'U'}) {
      turned += a.find(wanted) == std::string::npos ? ""
                : wanted == 'F'                     ? "T"
                : wanted == 'T'                     ? "F"
                                                    : "U";
    }
    EXPECT_EQ(truthsOf("(not " + text_a + ")"), turned);
  }
}

TEST(Holdings, AreJoinedAndKeptInTheirRange) {
  Variable v;
  v.lowest = -2;
  v.highest = 5;
  EXPECT_EQ(anything(v), (PossibleValues{-2, 5, false, {}}));
  v.lowest = -kNever;
  v.highest = kNever;
  EXPECT_EQ(anything(v), (PossibleValues{-kMost, kMost, false, {}}));
  v.lowest = -2;
  v.highest = 5;
  EXPECT_EQ(withinRange({-9, 3, false, {}}, v), (PossibleValues{-2, 3, false, {}}));
  EXPECT_EQ(withinRange({1, 9, false, {}}, v), (PossibleValues{1, 5, false, {}}));
  EXPECT_EQ(withinRange({5, 9, false, {}}, v), (PossibleValues{5, 5, false, {}}));
  EXPECT_EQ(withinRange({6, 9, false, {}}, v), (PossibleValues{0, 0, true, {}}));
  EXPECT_EQ(withinRange({1, 2, true, {}}, v), (PossibleValues{0, 0, true, {}}));
  const PossibleValues low{1, 2, false, {true, false, false}},
      high{4, 7, false, {false, true, false}}, never{0, 0, true, {false, false, true}};
  EXPECT_EQ(either(low, high), (PossibleValues{1, 7, false, {true, true, false}}));
  EXPECT_EQ(either(high, low), (PossibleValues{1, 7, false, {true, true, false}}));
  EXPECT_EQ(either(low, never), (PossibleValues{1, 2, false, {true, false, true}}));
  EXPECT_EQ(either(never, high), (PossibleValues{4, 7, false, {false, true, true}}));
  EXPECT_EQ(either(never, never), never);
}

// --- earliestEntries

std::vector<double> entriesOf(const std::string& text) {
  const Mission m = missionOf(kHeader + text);
  return earliestEntries(ProofContext(m, slocum()));
}
using Times = std::vector<double>;

TEST(EarliestEntries, AreWhatTheClocksAllow) {
  const auto ofGuard = [](const std::string& guard, const std::string& how = "goto") {
    return entriesOf(stateText("a", "case " + guard + " " + how + " b") +
                     stateText("b", "case true exit"))
        .at(1);
  };
  EXPECT_EQ(ofGuard("true"), 0);
  EXPECT_EQ(ofGuard("false"), kNever);
  EXPECT_EQ(ofGuard("(gt (sensor depth) 5:length)"), 0);
  EXPECT_EQ(ofGuard("(gt (sensor depth) 200:length)"), kNever);
  EXPECT_EQ(ofGuard("(ge missiontime 500:time)"), 500);
  EXPECT_EQ(ofGuard("(ge missiontime 500:time)", "call"), 500);
  EXPECT_EQ(ofGuard("(gt missiontime 500:time)"), 500);
  EXPECT_EQ(ofGuard("(ge resumetime 500:time)"), 500);
  EXPECT_EQ(ofGuard("(and (ge missiontime 500:time) (ge missiontime 700:time))"), 700);
  EXPECT_EQ(ofGuard("(or (ge missiontime 500:time) (ge missiontime 700:time))"), 500);
  EXPECT_EQ(ofGuard("(lt missiontime 500:time)"), 0);
  EXPECT_EQ(ofGuard("(and (ge missiontime 500:time) (lt missiontime 400:time))"), 500)
      << "no more than a bound";
}

TEST(EarliestEntries, WaitForHeldAndForWindows) {
  const auto with = [](const std::string& temporal, const std::string& guard) {
    return entriesOf("temporal " + temporal + "\n" +
                     stateText("a", "case (ge missiontime 100:time) goto b") +
                     stateText("b", "case " + guard + " goto c") + stateText("c", "case true exit"))
        .at(2);
  };
  const std::string deep = "(gt (sensor depth) 5:length)", both = "(or (temporal 0) " + deep + ")";
  EXPECT_EQ(with("held state b " + deep + " for 60:time", "(temporal 0)"), 160);
  EXPECT_EQ(with("held state b " + deep + " for 60:time", both), 100);
  EXPECT_EQ(with("held always " + deep + " for 60:time", "(temporal 0)"), 100);
  EXPECT_EQ(with("mean state b (sensor depth) over 300", "(gt (temporal 0) 5:length)"), 400);
}

TEST(EarliestEntries, HaveTheExitAmongThem) {
  const auto exitOf = [](const std::string& text) {
    const Mission m = missionOf(kHeader + text);
    return earliestExit(ProofContext(m, slocum()));
  };
  EXPECT_EQ(exitOf(stateText("a",
                             "case (ge missiontime 500:time) goto b case (ge missiontime "
                             "900:time) exit") +
                   stateText("b", "case (ge statetime 100:time) exit")),
            600);
  EXPECT_EQ(exitOf(stateText("a", "case (gt (sensor depth) 5:length) exit")), 0);
  EXPECT_EQ(exitOf(stateText("a", "case false exit")), kNever);
}

TEST(EarliestEntries, AddUpAlongTheFastestWay) {
  EXPECT_EQ(
      entriesOf(
          stateText("a",
                    "case (ge missiontime 500:time) goto b case (ge missiontime 800:time) goto c") +
          stateText("b", "case (ge statetime 100:time) goto c") +
          stateText("c", "case true return") + stateText("d", "case true goto a")),
      (Times{0, 500, 600, kNever}));
  EXPECT_EQ(
      entriesOf(
          stateText("a",
                    "case (ge missiontime 500:time) goto b case (ge missiontime 550:time) goto c") +
          stateText("b", "case (ge statetime 100:time) goto c") + stateText("c", "case true exit")),
      (Times{0, 500, 550}));
  EXPECT_EQ(entriesOf("always case (ge missiontime 300:time) goto b\n" +
                      stateText("a", "case true exit") + stateText("b", "case true exit")),
            (Times{0, 300}));
}

// --- mayEnterAfter

TEST(MayEnterAfter, FollowsEveryChain) {
  // "bc": after b, c may be entered.
  const auto pairs = [](const std::string& text) {
    const Mission m = missionOf(kHeader + text);
    std::string found;
    for (uint32_t after = 0; after < m.states.size(); ++after) {
      for (uint32_t state = 0; state < m.states.size(); ++state) {
        if (mayEnterAfter(m, {state}, {after})) {
          found += m.states[after].name + m.states[state].name + " ";
        }
      }
    }
    return found;
  };
  EXPECT_EQ(pairs(stateText("a", "case true goto b") + stateText("b", "case true goto c") +
                  stateText("c", "case true exit")),
            "ab ac bc ");
  EXPECT_EQ(pairs(stateText("a", "case true goto b") + stateText("b", "case true goto a")),
            "aa ab ba bb ");
  EXPECT_EQ(pairs(stateText("a", "case true call b case true goto c") +
                  stateText("b", "case true return") + stateText("c", "case true stay")),
            "ab ac bb bc ");
  EXPECT_EQ(pairs(stateText("a", "case true call b case true goto c") +
                  stateText("b", "case true exit") + stateText("c", "case true stay")),
            "ab ac ");
  EXPECT_EQ(pairs("always case true goto b\n" + stateText("a", "case true exit") +
                  stateText("b", "case true exit")),
            "ab bb ");
  EXPECT_EQ(pairs("always case true call b\n" + stateText("a", "case true goto c") +
                  stateText("b", "case true return") + stateText("c", "case true exit")),
            "ab ac bb bc cb cc ");
}

// --- relevanceFor

constexpr const char* kWrittenWorld =
    "behaviour profile plain symbol \"\" () reads ()\n"
    "behaviour route way symbol \"\" () reads ()\n";

/// What matters of a mission: variables by name, temporals by number, clocks, and of each state
/// whether its profile and its route run.
std::string relevantIn(const std::string& text, bool vehicle = false) {
  const Mission m = missionOf(kHeader + kWrittenWorld + text);
  const ConeOfInfluence relevance = relevanceFor(m, {}, vehicle);
  std::string found;
  for (size_t i = 0; i < m.variables.size(); ++i) {
    found += relevance.variables[i] ? m.variables[i].name + " " : "";
  }
  for (size_t i = 0; i < m.temporals.size(); ++i) {
    found += relevance.temporals[i] ? std::to_string(i) + " " : "";
  }
  for (size_t i = 0; i < m.states.size(); ++i) {
    found += relevance.profiles[i] ? m.states[i].name + ".profile " : "";
    found += relevance.routes[i] ? m.states[i].name + ".route " : "";
  }
  EXPECT_EQ(relevance.vehicle, vehicle);
  return found + (relevance.state_time ? "statetime " : "") +
         (relevance.resume_time ? "resumetime " : "");
}

std::string number(const std::string& name, const std::string& initial = "0",
                   const std::string& kind = "mission") {
  return "variable " + name + ": number " + kind + " " +
         (initial.empty() ? "" : "initial " + name + " " + initial + " ");
}

/// A state with its own profile and route, and a case that asks for `x`.
std::string asking(const std::string& profile, const std::string& route = "",
                   const std::string& more = "") {
  return "state a route way begin " + route + " end profile plain begin " + profile + " end " +
         more + " case (gt (var x) 1) exit\n";
}

TEST(ConeOfInfluence, HasWhatGuardsRead) {
  EXPECT_EQ(relevantIn(number("x") + number("y") + stateText("a", "case true exit")), "");
  EXPECT_EQ(relevantIn(number("x") + number("y") + stateText("a", "case (gt (var x) 1) exit")),
            "x ");
  EXPECT_EQ(relevantIn(number("x") + number("y") + "always case (gt (var y) 1) stay " +
                       stateText("a", "case true exit")),
            "y ");
  EXPECT_EQ(relevantIn(stateText("a",
                                 "case (gt statetime 1:time) exit case (gt (sensor depth) "
                                 "1:length) stay")),
            "statetime ");
  EXPECT_EQ(relevantIn(stateText("a",
                                 "case (gt resumetime 1:time) exit case (gt (sensor depth) "
                                 "1:length) stay")),
            "resumetime ");
  EXPECT_EQ(relevantIn("temporal mean always (sensor depth) over 10 temporal mean always "
                       "(sensor depth) over 20 " +
                       stateText("a",
                                 "case (gt (temporal 1) 1:length) exit case (gt (sensor "
                                 "depth) 1:length) stay")),
            "1 statetime ");
  EXPECT_EQ(relevantIn(number("x") + number("y") +
                       "temporal became always (gt (var x) 1) temporal held always (gt (var y) 1) "
                       "for 5:time " +
                       stateText("a", "case (temporal 0) exit")),
            "x 0 ");
  EXPECT_EQ(relevantIn(number("x") + number("y") +
                       "temporal held always (gt (var x) 1) for (mul (var y) 1:time) " +
                       stateText("a", "case (temporal 0) exit")),
            "x y 0 ");
}

TEST(ConeOfInfluence, HasWhatVariablesOfGuardsAreComputedFrom) {
  EXPECT_EQ(relevantIn(number("y") + number("z") + number("x", "(var y)") +
                       stateText("a", "case (gt (var x) 1) exit")),
            "y x ");
  const std::string three = number("x") + number("y") + number("z");
  EXPECT_EQ(relevantIn(three + stateText("a",
                                         "case (gt (var x) 1) do set x (var y) end stay "
                                         "case true do set z (var y) end exit")),
            "x y ");
  EXPECT_EQ(relevantIn(three + stateText("a",
                                         "case (gt (var x) 1) do if (gt (var y) 1) set x 2 "
                                         "end if (gt (var z) 1) log n () end end exit")),
            "x y ");
  EXPECT_EQ(relevantIn(three + stateText("a",
                                         "case (gt (var x) 1) do if (gt (var z) 1) log n () "
                                         "else set x 3 end end exit")),
            "x z ");
  EXPECT_EQ(relevantIn(three + stateText("a",
                                         "case (gt (var z) 1) do set z (var y) end stay case "
                                         "true do set y (var x) end stay")),
            "x y z ")
      << "by way of another";
  const std::string passed = number("y") + number("z") + number("p", "", "argument of b") +
                             number("q", "", "argument of b");
  const std::string to = "state b (p, q) route drift () profile glide () case (gt (var p) 1) exit ";
  EXPECT_EQ(relevantIn(passed + stateText("a", "case true goto b ((var y), (var z))") + to),
            "y p ");
  EXPECT_EQ(relevantIn(passed + "always case true goto b ((var z), (var y)) " +
                       stateText("a", "case true exit") + to),
            "z p ");
}

TEST(ConeOfInfluence, HasGuardsOfProfilesAndRoutesThatSetItsVariables) {
  const std::string two = number("x") + number("y");
  EXPECT_EQ(
      relevantIn(two + asking("entry do log n () end case (gt (var y) 1) do log n () end stay")),
      "x ");
  EXPECT_EQ(
      relevantIn(two + asking("entry do set x 2 end case (gt (var y) 1) do log n () end stay")),
      "x y a.profile ")
      << "and so what its guards read";
  EXPECT_EQ(relevantIn(two + asking("", "case (gt (var y) 1) do set x 2 end stay")),
            "x y a.route ");
  EXPECT_EQ(relevantIn(two + asking("case true do set x 2 end stay case (gt (var y) 1) stay")),
            "x y a.profile ");
  EXPECT_EQ(relevantIn(two + asking("case true do if (gt (var y) 1) else set x 2 end end stay")),
            "x y a.profile ");
  EXPECT_EQ(relevantIn(number("y") + "variable d: bool profile of a state a initial d false route "
                                     "drift () profile plain done d begin case (gt (var y) 1) done "
                                     "end case (var d) exit"),
            "y d a.profile ")
      << "it is done";
}

TEST(ConeOfInfluence, OfTheDepthHasWhatCommandsDepths) {
  const std::string two = number("x") + number("y");
  for (const char* command :
       {"descend ((mul (var y) 1:length), 0.4:angle)", "ascend ((mul (var y) 1:length), 0.4:angle)",
        "hover ((mul (var y) 1:length))"}) {
    const std::string text = two + asking("entry do " + std::string(command) + " end");
    EXPECT_EQ(relevantIn(text), "x ") << command;
    EXPECT_EQ(relevantIn(text, true), "x y a.profile ") << command;
  }
  EXPECT_EQ(relevantIn(two + asking("entry do surface () end"), true), "x a.profile ");
  EXPECT_EQ(relevantIn(two + asking("", "entry do steer ((mul (var y) 1:angle)) end"), true), "x ");
  EXPECT_EQ(relevantIn(stateText("a", "case true exit"), true), "a.profile a.route ")
      << "in C they may command anything";
  EXPECT_EQ(relevantIn(stateText("a", "case true exit"), false), "");
}

// --- knownRoughly

std::string roughOf(const std::string& condition, bool vehicle = false,
                    const std::string& profile = "glide ()",
                    const std::string& route = "way begin end") {
  const Mission m =
      missionOf(kHeader +
                "behaviour profile plain symbol \"\" () reads ()\n"
                "behaviour route way symbol \"\" () reads ()\n"
                "sensor lat: latitude vehicle m_lat id 12 encoding degrees_minutes to_si 1 lowest "
                "-9000 highest 9000 stale_after 20\n"
                "function f symbol f (): number lowest -3 highest 7\nuse f\n"
                "table number (4, -9, 2)\n"
                "temporal mean always (sensor depth) over 10\n"
                "temporal became always (gt (sensor depth) 5:length)\n"
                "temporal held always (gt (sensor depth) 5:length) for 5:time\n"
                "state a route " +
                route + " profile " + profile + " case " + condition + " stay\n");
  return knownRoughly(ProofContext(m, slocum()), relevanceFor(m, {}, vehicle));
}

TEST(KnownRoughly, NamesWhatTheSolverDoesNotCompute) {
  const std::string products = "products of values that are measured or change",
                    quotients = "quotients of values that are measured or change",
                    functions = "square roots and angles",
                    places = "positions, their distances and bearings",
                    watched = "what `became` and `held` observe between two ticks",
                    windows = "windows", code = "C functions";
  const std::string depth = "(div (sensor depth) 1:length)";
  const auto rough = [](const std::string& number) { return roughOf("(gt " + number + " 1)"); };
  for (const std::string& plain : {depth, "(mul 2 " + depth + ")", "(mul " + depth + " 2)",
                                   "(div " + depth + " 2)", "(add " + depth + " " + depth + ")"}) {
    EXPECT_EQ(rough(plain), "") << plain;
  }
  EXPECT_EQ(rough("(mul " + depth + " " + depth + ")"), products);
  EXPECT_EQ(rough("(div 1 " + depth + ")"), quotients);
  EXPECT_EQ(rough("(sqrt " + depth + ")"), functions);
  EXPECT_EQ(rough("(sin (mul 1:angle " + depth + "))"), functions);
  EXPECT_EQ(rough("(cos (mul 1:angle " + depth + "))"), functions);
  EXPECT_EQ(rough("(tan (mul 1:angle " + depth + "))"), functions);
  EXPECT_EQ(rough("(div (atan2 (sensor depth) 1:length) 1:angle)"), functions);
  EXPECT_EQ(rough("(div (distance (sensor lat) 2:longitude 4:latitude 3:longitude) 1:length)"),
            places);
  EXPECT_EQ(rough("(div (bearing (sensor lat) 2:longitude 4:latitude 3:longitude) 1:angle)"),
            places);
  EXPECT_EQ(rough("(element 0 " + depth + ")"), places);
  EXPECT_EQ(rough("(div (temporal 0) 1:length)"), windows);
  EXPECT_EQ(rough("(call 0)"), code);
  EXPECT_EQ(roughOf("(temporal 1)"), watched);
  EXPECT_EQ(roughOf("(temporal 2)"), watched);
  EXPECT_EQ(rough("(mul (sqrt " + depth + ") (call 0))"),
            products + ", " + functions + ", " + code);
  EXPECT_EQ(roughOf("true"), "");
  EXPECT_EQ(roughOf("true", true), code) << "the profile's";
  EXPECT_EQ(roughOf("true", true, "plain begin end"), "");
  EXPECT_EQ(roughOf("true", true, "plain begin end", "drift ()"), code) << "the route's";
  EXPECT_EQ(roughOf("true", false, "plain begin end", "drift ()"), "");
}

// --- leavingOf

/// Of state `a`, that is entered at `since`; between ticks there are 20 s.
Leaving leavingAt(double since, const std::string& cases, const std::string& always = "",
                  bool own_first = false) {
  const Mission m = missionOf(kHeader + (always.empty() ? "" : "always " + always + "\n") +
                              stateText("a", cases) + stateText("b", "case true exit"));
  const ProofContext proof_context = ProofContext(m, slocum()).withoutPowerCuts();
  Interruptions interruptions;
  interruptions.own_first = own_first;
  for (const Case& c : m.always) {
    interruptions.cases.push_back(&c);
  }
  return leavingOf(proof_context, m.states[0], interruptions, {}, {0, since});
}

TEST(Leaving, IsATickAfterWhatMustBeTrue) {
  const auto by = [](double since, const std::string& cases) { return leavingAt(since, cases).by; };
  EXPECT_EQ(by(50, "case (ge statetime 100:time) exit"), 170);
  EXPECT_EQ(by(50, "case (ge resumetime 100:time) exit"), 170);
  EXPECT_EQ(by(50, "case (le 100:time statetime) exit"), 170);
  EXPECT_EQ(by(50, "case (ge missiontime 100:time) exit"), 120);
  EXPECT_EQ(by(300, "case (ge missiontime 100:time) exit"), 320);
  EXPECT_EQ(by(50, "case true exit"), 70);
  EXPECT_EQ(by(50, "case (ge statetime -5:time) exit"), 70);
  EXPECT_EQ(by(50, "case (gt (sensor depth) 5:length) exit"), kNever);
  EXPECT_EQ(by(50, "case (gt (sensor depth) 5:length) stay case (ge statetime 100:time) exit"),
            kNever);
  EXPECT_EQ(by(50, "case (gt (sensor depth) 500:length) stay case (ge statetime 100:time) exit"),
            170);
  EXPECT_EQ(by(50, "case (ge statetime 100:time) goto b case (ge statetime 30:time) exit"), 100);
  EXPECT_EQ(by(50, "case (ge statetime 100:time) stay"), kNever);
}

TEST(Leaving, NoCaseFiresAfterOneBeforeItMustHave) {
  const auto latest = [](const std::string& cases) { return leavingAt(50, cases).latest; };
  EXPECT_EQ(latest("case (ge statetime 100:time) goto b case (gt (sensor depth) 5:length) exit"),
            (Times{170, 150}));
  EXPECT_EQ(latest("case (gt (sensor depth) 5:length) exit case (ge statetime 100:time) goto b"),
            (Times{170, 170}));
  EXPECT_EQ(latest("case (gt (sensor depth) 5:length) exit"), Times{kNever});
  EXPECT_EQ(latest("case (ge statetime 100:time) goto b case (ge statetime 30:time) exit"),
            (Times{100, 100}));
}

TEST(Leaving, LooksAtTheTimesThatAreNamed) {
  const auto looks = [](const std::string& guard) {
    return leavingAt(50, "case " + guard + " exit").looks;
  };
  EXPECT_EQ(looks("true"), 3U) << "for the times, at the first tick, at any after it";
  EXPECT_EQ(looks("(ge statetime 100:time)"), 5U) << "and 100 s, and right after them";
  EXPECT_EQ(looks("(ge 100:time resumetime)"), 5U);
  EXPECT_EQ(looks("(ge missiontime 100:time)"), 5U);
  EXPECT_EQ(looks("(ge missiontime 0:time)"), 5U);
  EXPECT_EQ(looks("(ge missiontime -5:time)"), 3U);
  EXPECT_EQ(looks("(ge statetime -5:time)"), 3U);
  EXPECT_EQ(looks("(ge missiontime 1.7976931348623157e308:time)"), 3U) << "it has no end";
  EXPECT_EQ(looks("(ge missiontime (mul (mul 1e300 1e300) 1:time))"), 3U) << "it has no value";
  EXPECT_EQ(looks("(eq statetime 100:time)"), 3U);
  EXPECT_EQ(looks("(ge (age depth) 100:time)"), 3U);
  EXPECT_EQ(looks("(and (ge statetime 100:time) (ge missiontime 200:time))"), 7U);
}

TEST(Leaving, AnInterruptionComesFirstOrAfterItsOwn) {
  const std::string own = "case (gt (sensor depth) 5:length) exit",
                    always = "case (ge missiontime 300:time) goto b";
  const Leaving first = leavingAt(50, own, always), second = leavingAt(50, own, always, true);
  EXPECT_EQ(first.by, 320);
  EXPECT_EQ(first.latest, Times{300});
  EXPECT_EQ(second.by, 320);
  EXPECT_EQ(second.latest, Times{320});
}

}  // namespace
}  // namespace glider::ir::prove
