// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Invariants written by hand, and twins that must be refused.

#include "tests/unit/certify/judge.h"

#include <fmt/format.h>

#include <gmock/gmock.h>
#include <map>

namespace glider::ir::certify {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

using Formulas = std::map<std::string, std::string>;

Formula from(Formulas formulas) {
  return [formulas = std::move(formulas)](const std::string& words) {
    const auto found = formulas.find(words);
    return found == formulas.end() ? std::string() : found->second;
  };
}

/// The survey of docs/verification.md, with other requirements.
Mission survey(const std::string& requirement) {
  return compiled("mission survey\nrequire " + requirement + R"(
const deepest = 25 m
state look
begin
  flightprofile yo(5 m, deepest, 26 deg, 26 deg)
  sensors       missiontime, depth, temp
  events
    case missiontime >= 1 h goto home
    case temp > 20 degC     call hot
end
state hot
begin
  flightprofile yo(10 m, deepest, 26 deg, 26 deg)
  sensors       statetime, depth, temp
  events
    case statetime >= 10 min return
end
state home
begin
  flightprofile surfaced
  sensors       statetime
  events
    case statetime >= 10 min exit
end
)");
}

Formulas surveyTimes() {
  return {
      {"`look`", "(< |time| 3600.0)"},
      {"`hot`, called by `look`", "(and (< |entered 1| 3600.0) (< (- |time| |entered 1|) 600.0))"},
      {"`look`, just returned to", "(< |time| 4500.0)"},
      {"`home`", "(and (< |entered 0| 4800.0) (< (- |time| |entered 0|) 600.0))"}};
}

TEST(Invariants, OfAnEndAreAccepted) {
  NEEDS_CVC5();
  EXPECT_THAT(judged(survey("exit within 95 min"), from(surveyTimes())), IsEmpty());
}

TEST(Invariants, OfATighterEndAreRefused) {
  NEEDS_CVC5();
  const auto refused = judged(survey("exit within 5699 s"), from(surveyTimes()));
  ASSERT_EQ(refused.size(), 1u);
  EXPECT_THAT(refused[0], HasSubstr("`home`: the requirement is not violated: sat"));
}

TEST(Invariants, ThatAreMissingOrWeakerAreRefused) {
  NEEDS_CVC5();
  const Mission mission = survey("exit within 95 min");
  for (const auto& [words, formula] : surveyTimes()) {
    Formulas less = surveyTimes();
    less.erase(words);
    EXPECT_THAT(judged(mission, from(less)), Not(IsEmpty())) << words;
    less = surveyTimes();
    less[words] = "true";
    EXPECT_THAT(judged(mission, from(less)), Not(IsEmpty())) << words;
    less[words] = "(< |time| |entered 0|)";
    EXPECT_THAT(judged(mission, from(less)), Not(IsEmpty())) << words;
  }
}

TEST(Invariants, ThatAreNoTermAreRefused) {
  NEEDS_CVC5();
  const Mission mission = survey("exit within 95 min");
  for (const char* formula : {"true)) (assert false", "(< |nothing| 3.0)", "3.0", "glider.c0"}) {
    Formulas formulas = surveyTimes();
    formulas["`home`"] = formula;
    EXPECT_THAT(judged(mission, from(formulas)), Not(IsEmpty())) << formula;
  }
}

TEST(Invariants, OfDepth) {
  NEEDS_CVC5();
  const Formula formula = [](const std::string&) { return "(<= |deepest| 30.0)"; };
  EXPECT_THAT(judged(survey("always depth <= 30 m"), formula), IsEmpty());
  EXPECT_THAT(judged(survey("always depth <= 29 m"), formula), Not(IsEmpty()));
  const Formula weaker = [](const std::string&) { return "(<= |deepest| 31.0)"; };
  EXPECT_THAT(judged(survey("always depth <= 30 m"), weaker), Not(IsEmpty()));
}

TEST(Invariants, OfWhatWasEntered) {
  NEEDS_CVC5();
  const Formula formula = [](const std::string& words) {
    return words == "`home`" ? "true" : "(not |after seen|)";
  };
  EXPECT_THAT(judged(survey("never look after home"), formula), IsEmpty());
  EXPECT_THAT(judged(survey("never home after look"), formula), Not(IsEmpty()));
  const Formula nothing = [](const std::string&) { return "true"; };
  EXPECT_THAT(judged(survey("never home after hot"), nothing), Not(IsEmpty()));
}

TEST(Invariants, OfSurfacing) {
  NEEDS_CVC5();
  const auto mission = [](const char* time) {
    return compiled(fmt::format(R"(mission m
require surfaces every {}
resume within 20 s
state dive
begin
  flightprofile yo(5 m, 20 m, 26 deg, 26 deg)
  sensors statetime
  events
    case statetime >= 1 h goto up
end
state up
begin
  flightprofile surfaced
  sensors statetime
  events
    case statetime >= 15 min exit
end
)",
                                time));
  };
  // `up` begins at most 3620 s after the surface, at 25 m or above; 120 s later the vehicle climbs
  // at 0.05 m/s, so 460 s (and a tick) after the command it is above 2 m: 580 s + 20 s.
  const auto formula = [](const std::string& words) -> std::string {
    return words == "`dive`" ? "(and (= |entered 0| 0.0) (< |time| 3600.0) (<= |deepest| 25.0)"
                               " (=> |climbing| (>= |top| 10.0)))"
                             : "(and |climbing| (<= |top| 0.0) (<= |deepest| 25.0) (= |climbing "
                               "since| |entered 0|)"
                               " (<= |entered 0| 3620.0) (or (= |surfaced| |time|)"
                               " (< (- |time| |climbing since|) 580.0)))";
  };
  EXPECT_THAT(judged(mission("4220 s"), formula), IsEmpty());
  EXPECT_THAT(judged(mission("4100 s"), formula), Not(IsEmpty()));
  // 20 s less would do if the surface were at 3 m.
  const auto earlier = [&](const std::string& words) {
    std::string text = formula(words);
    const size_t at = text.find("580.0");
    return at == std::string::npos ? text : text.replace(at, 5, "560.0");
  };
  EXPECT_THAT(judged(mission("4200 s"), earlier), Not(IsEmpty()));
}

TEST(Invariants, RangesAreShownToo) {
  NEEDS_CVC5();
  const auto mission = [](const char* guard) {
    return compiled(fmt::format(R"(mission m
require always dives <= 5
var dives : number = 0 in 0 .. 5
state look
begin
  flightprofile yo(5 m, 20 m, 26 deg, 26 deg)
  sensors       missiontime, depth
  events
    case missiontime >= 1 h exit
    case {} && became(depth > 15 m) do set dives = dives + 1 end stay
end
)",
                                guard));
  };
  const Formula nothing = [](const std::string&) { return "true"; };
  EXPECT_THAT(judged(mission("dives < 5"), nothing), IsEmpty());
  const auto refused = judged(mission("dives <= 5"), nothing);
  ASSERT_FALSE(refused.empty());
  EXPECT_THAT(fmt::format("{}", fmt::join(refused, "\n")),
              HasSubstr("variables stay in their declared ranges: sat"));
}

}  // namespace
}  // namespace glider::ir::certify
