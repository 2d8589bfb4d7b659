// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "analysis/coverage.h"

#include "compiler/proving.h"

#include <gtest/gtest.h>

#include <string>

namespace glider::analysis {
namespace {

const std::string kAlone = "each proof would hold without any one of these: ";

/// What `check --report` says of a mission.
std::string lineOf(const std::string& text) {
  const auto compiled = compiler::compileText("m.mission", text);
  EXPECT_TRUE(compiled && compiled->checked);
  support::DiagnosticEngine unheard;
  const compiler::Checked& checked = *compiled->checked;
  const auto found = compiler::prove(checked, {}, unheard);
  const auto coverage = coverageOf(checked, found.requirements, {});
  return coverage ? coverageLine(*coverage, checked) : "none";
}

/// The cases are in lines 4 (`always`), 10, 11, 12 (`look`), 19 and 26.
std::string lineFor(const std::string& requirements) {
  return lineOf("mission m\n" + requirements + R"(
always
  case temp > 30 degC && missiontime < 30 min call cool
state look
begin
  flightprofile yo(5 m, 25 m, 26 deg, 26 deg)
  sensors       missiontime, temp
  events
    case missiontime >= 1 h exit
    case temp < 10 degC && missiontime < 30 min call cold
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
}

TEST(Coverage, NamesWhatNoRequirementDependsOn) {
  EXPECT_EQ(lineFor("require can reach cold"),
            kAlone + "5 of 6 cases (lines 4, 10, 12, 19, 26); state `cool`");
  EXPECT_EQ(lineFor("require exit within 80 min"),
            kAlone + "3 of 6 cases (lines 4, 11, 12); states `cold`, `cool`");
}

TEST(Coverage, AStateThatARequirementNamesIsNeeded) {
  EXPECT_EQ(lineFor("require can reach cold\nrequire never cool after cold\nrequire never cool")
                .find("cool"),
            std::string::npos);
}

TEST(Coverage, OnlyWhatIsProvedCounts) {
  EXPECT_EQ(lineFor(""), "none");
  EXPECT_EQ(lineFor("require exit within 5 min"), "none");
}

/// Without the case in line 9, that in line 10 would be a call without end.
TEST(Coverage, APartWithoutWhichTheMissionHasErrorsIsNeeded) {
  EXPECT_EQ(lineOf(R"(mission m
require stack <= 0
state look
begin
  flightprofile yo(5 m, 25 m, 26 deg, 26 deg)
  sensors       missiontime
  events
    case missiontime >= 1 h exit
    case true stay
    case true call look
end
)"),
            kAlone + "2 of 3 cases (lines 8, 10)");
}

}  // namespace
}  // namespace glider::analysis
