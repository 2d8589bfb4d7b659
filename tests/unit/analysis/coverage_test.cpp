// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "analysis/coverage.h"

#include "compiler/proving.h"

#include <gtest/gtest.h>

#include <string>

namespace glider::analysis {
namespace {

/// What `check --report` says of the mission that makes `requirements`.
std::string lineFor(const std::string& requirements) {
  const auto compiled = compiler::compileText("m.mission", "mission m\n" + requirements + R"(
always
  case temp > 30 degC call cool
state look
begin
  flightprofile yo(5 m, 25 m, 26 deg, 26 deg)
  sensors       missiontime, temp
  events
    case missiontime >= 1 h exit
    case temp < 10 degC     call cold
    case temp < 5 degC      stay
end
state cold
begin
  flightprofile yo(5 m, 45 m, 26 deg, 26 deg)
  sensors       statetime
  events
    case statetime >= 5 min return
end
state cool
begin
  flightprofile surfaced
  sensors       statetime
  events
    case statetime >= 5 min return
end
)");
  EXPECT_TRUE(compiled && compiled->checked);
  support::DiagnosticEngine unheard;
  const compiler::Checked& checked = *compiled->checked;
  const auto found = compiler::prove(checked, {}, unheard);
  const auto coverage = coverageOf(checked, found.requirements);
  return coverage ? coverageLine(*coverage, checked) : "none";
}

/// The cases are in lines 4 (`always`), 10, 11, 12 (`look`), 19 and 26.
TEST(Coverage, NamesWhatNoRequirementDependsOn) {
  EXPECT_EQ(lineFor("require can reach cold"),
            "no proved requirement depends on 2 of 6 cases (lines 4, 12) or on state `cool`");
  EXPECT_EQ(lineFor("require exit within 80 min"),
            "no proved requirement depends on 3 of 6 cases (lines 4, 11, 12) or on states `cold`, "
            "`cool`");
}

TEST(Coverage, OnlyWhatIsProvedCounts) {
  EXPECT_EQ(lineFor(""), "none");
  EXPECT_EQ(lineFor("require exit within 5 min"), "none");
}

/// Without the second of them the first would be left for ever: an error of its own.
TEST(Coverage, APartWithoutWhichTheMissionHasErrorsIsNeeded) {
  EXPECT_EQ(lineFor("require stack <= 5").find("19"), std::string::npos);
}

}  // namespace
}  // namespace glider::analysis
