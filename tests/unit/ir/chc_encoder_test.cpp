// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// How far time may pass between two ticks that a proof looks at: not past what the clocks turn, by
// more than the gap.

#include "ir/prove/encoding/chc_encoder.h"

#include "ir/prove/encoding/cone_of_influence.h"
#include "ir/prove/encoding/question.h"
#include "tests/unit/ir/missions.h"
#include "tests/unit/ir/slocum.h"

#include <algorithm>
#include <optional>

namespace glider::ir::prove {
namespace {

/// Whether time may pass from 500 s, where the first state was entered at 300 s and resumed at
/// 450 s, to `then`; with `held` in the first variable. A gap is 20 s.
bool mayPassTo(double then, const std::string& cases, const std::string& variables = "",
               std::optional<double> held = std::nullopt) {
  const Mission mission =
      missionOf(kHeader + variables +
                stateText("a", "case (gt (sensor temp) 30:temperature) call b " + cases) +
                stateText("b",
                          "case (gt statetime 1000:time) return "
                          "case (gt resumetime 1000:time) return"));
  const ProofContext proof_context = ProofContext(mission, slocum()).withoutPowerCuts();
  z3::context context;
  const ConeOfInfluence relevance = relevanceFor(mission, {}, false);
  const SafetyProperty watch;
  ChcEncoder writer(context, proof_context, relevance, watch);
  EXPECT_TRUE(writer.run());
  const auto passes = [](const Rule& rule) {
    return rule.from && rule.to && rule.from->side == Side::Done && rule.to->side == Side::Due &&
           rule.from->control.state == StateId{0};
  };
  const auto rule = std::ranges::find_if(writer.rules(), passes);
  if (rule == writer.rules().end()) {
    ADD_FAILURE() << "time passes in no rule";
    return false;
  }
  Question question(context, 1000000);
  question.add(rule->condition && rule->before->mission_time == 500 &&
               rule->before->entered.back() == 300 && rule->before->resumed == 450 &&
               rule->after->mission_time == realOf(context, then));
  if (held) {
    question.add(rule->before->store.numbers.at(0).value == realOf(context, *held));
  }
  return question.ask() == Answer::Yes;
}

TEST(Rules, TimePassesAGapWithAnyGuardOnTheClocks) {
  for (const char* guard : {"(ge resumetime 60:time)", "true", "(lt missiontime 510:time)"}) {
    const std::string cases = std::string("case ") + guard + " exit";
    EXPECT_FALSE(mayPassTo(499, cases)) << guard;
    EXPECT_TRUE(mayPassTo(500, cases)) << guard;
    EXPECT_TRUE(mayPassTo(520, cases)) << guard;
  }
  EXPECT_FALSE(mayPassTo(521, "case true exit"));
  EXPECT_TRUE(mayPassTo(1e6, "case false exit"));
}

/// Each turns at 600 s.
TEST(Rules, TimePassesNoGuardOfTheClocksByMoreThanAGap) {
  for (const char* clock : {"missiontime 600:time", "statetime 300:time", "resumetime 150:time"}) {
    const std::string guard = std::string("(ge ") + clock + ")";
    for (const std::string& cases :
         {"case " + guard + " exit", "case (and (gt (sensor depth) 5:length) " + guard + ") exit",
          "case (not " + guard + ") stay case (gt (sensor depth) 5:length) exit"}) {
      const bool before = cases.starts_with("case (not");  // it fires on each tick until then
      EXPECT_EQ(mayPassTo(619, cases), !before) << cases;
      EXPECT_FALSE(mayPassTo(621, cases)) << cases;
    }
  }
}

TEST(Rules, TimePassesNoneOfSeveralConditions) {
  const auto from = [](const char* time) {
    return std::string("case (and (gt (sensor depth) 5:length) (ge missiontime ") + time +
           ":time)) exit ";
  };
  for (const std::string& cases : {from("600") + from("700"), from("700") + from("600")}) {
    EXPECT_TRUE(mayPassTo(619, cases)) << cases;
    EXPECT_FALSE(mayPassTo(621, cases)) << cases;
  }
}

TEST(Rules, TimePassesNoTimeThatAVariableHolds) {
  const std::string cases = "case (ge missiontime (var t)) exit";
  const std::string variable =
      "variable t: time mission lowest 550 highest 600\ninitial t 560:time\n";
  EXPECT_TRUE(mayPassTo(599, cases, variable, 580));
  EXPECT_FALSE(mayPassTo(601, cases, variable, 580));
}

}  // namespace
}  // namespace glider::ir::prove
