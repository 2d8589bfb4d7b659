// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/support/command.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <gmock/gmock.h>

namespace glider::tests {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

const std::string kDrawn = GLIDER_SOURCE_DIR "/missions/figure2.mission";

TEST(GraphCommand, WritesASvgNamedAfterTheMission) {
  const TemporaryFolder folder;
  const Outcome outcome =
      runShell("cd " + folder.path().string() + " && $GLIDERCC graph " + kDrawn);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("figure2.svg: mission sampleMission, 3 states"));
  const std::string svg = slurp(folder.path() / "figure2.svg");
  EXPECT_TRUE(svg.starts_with("<svg xmlns=\"http://www.w3.org/2000/svg\"")) << svg.substr(0, 80);
  EXPECT_TRUE(svg.ends_with("</svg>\n"));
  EXPECT_THAT(svg, HasSubstr("missiontime &gt;= 2000"));
}

TEST(GraphCommand, TheSameMissionGivesTheSameBytes) {
  const Outcome one = runShell("$GLIDERCC graph -o - " + kDrawn);
  const Outcome two = runShell("$GLIDERCC graph -o - " + kDrawn);
  EXPECT_EQ(one.status, 0) << one.err;
  EXPECT_EQ(one.out, two.out);
  EXPECT_THAT(one.err, IsEmpty());
}

TEST(GraphCommand, OtherFormats) {
  EXPECT_THAT(runShell("$GLIDERCC graph --format dot -o - " + kDrawn).out, HasSubstr("digraph"));
  EXPECT_THAT(runShell("$GLIDERCC graph --format json -o - " + kDrawn).out,
              HasSubstr("\"transition\": \"call\""));
  EXPECT_THAT(runShell("$GLIDERCC graph --format promela -o - " + kDrawn).out,
              HasSubstr("proctype"));
  const Outcome wrong = runShell("$GLIDERCC graph --format png -o - " + kDrawn);
  EXPECT_EQ(wrong.status, 2);
  EXPECT_THAT(wrong.err, HasSubstr("svg"));
}

// `deep` is reached by a depth that no sensor reads, and by a case that an earlier one hides.
const std::string kProvedDead = R"(mission m

state s
begin
  flightprofile surfaced
  sensors missiontime, depth
  events
    case depth > 5000 m      goto deep
    case missiontime >= 1 h  exit
    case missiontime >= 2 h  call deep
end

state deep
begin
  flightprofile surfaced
  sensors statetime
  events
    case statetime >= 1 h exit
end
)";

TEST(GraphCommand, WhatIsProvedDeadIsMarkedAsData) {
  const TemporaryFolder folder;
  const std::string mission = folder.write("m.mission", kProvedDead).string();
  const Outcome outcome = runShell("$GLIDERCC graph --format json -o - " + mission);
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto graph = nlohmann::json::parse(outcome.out);
  const auto& cases = graph["states"][0]["cases"];
  EXPECT_EQ(cases[0]["never"], "never fires: its condition cannot be true");
  EXPECT_FALSE(cases[1].contains("never"));
  EXPECT_EQ(cases[2]["never"],
            "never fires: whenever its condition is true, an earlier case fires");
  EXPECT_EQ(graph["states"][0]["reached"], true);
  EXPECT_EQ(graph["states"][1]["reached"], false);
  EXPECT_EQ(graph["states"][1]["led_to_in_vain"], true);
}

TEST(GraphCommand, WhatIsProvedDeadIsMarkedInPictures) {
  const TemporaryFolder folder;
  const std::string mission = folder.write("m.mission", kProvedDead).string();
  const std::string svg = runShell("$GLIDERCC graph -o - " + mission).out;
  EXPECT_THAT(svg, HasSubstr("class=\"unreached\""));
  EXPECT_THAT(svg, HasSubstr("only cases that never fire lead here"));
  EXPECT_THAT(svg, HasSubstr(">never fires</text>"));
  EXPECT_THAT(svg, HasSubstr(">never entered</text>"));
  const std::string dot = runShell("$GLIDERCC graph --format dot -o - " + mission).out;
  EXPECT_THAT(dot, HasSubstr("style=\"rounded,dotted\""));
  EXPECT_THAT(dot, HasSubstr("style=dotted"));
  const std::string alive = runShell("$GLIDERCC graph -o - " + kDrawn).out;
  EXPECT_THAT(alive, testing::Not(HasSubstr("class=\"unreached\"")));
  EXPECT_THAT(alive, testing::Not(HasSubstr(">never")));
}

TEST(GraphCommand, TheIrTextFormIsDrawnToo) {
  const TemporaryFolder folder;
  const std::string ir = (folder.path() / "m.ir").string();
  ASSERT_EQ(runShell("$GLIDERCC build --emit ir " + kDrawn + " -o " + ir).status, 0);
  const Outcome outcome = runShell("$GLIDERCC graph -o - " + ir);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr(">s1</text>"));
}

TEST(GraphCommand, AMissionWithErrorsIsNotDrawn) {
  const TemporaryFolder folder;
  const auto mission = folder.write("bad.mission", "mission bad\nstate s\nbegin\n");
  const Outcome outcome =
      runShell("cd " + folder.path().string() + " && $GLIDERCC graph bad.mission");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "bad.svg"));
}

TEST(GraphCommand, NeverWritesOverTheMission) {
  const TemporaryFolder folder;
  const auto mission = folder.write("m.mission", slurp(kDrawn));
  const Outcome outcome =
      runShell("$GLIDERCC graph " + mission.string() + " -o " + mission.string());
  EXPECT_EQ(outcome.status, 2);
  EXPECT_THAT(outcome.err, HasSubstr("GL9350"));
  EXPECT_EQ(slurp(mission), slurp(kDrawn));
}

TEST(GraphCommand, WhatCannotBeReadOrWritten) {
  EXPECT_EQ(runShell("$GLIDERCC graph /nowhere.mission").status, 2);
  EXPECT_EQ(runShell("$GLIDERCC graph " + kDrawn + " -o /nowhere/x.svg").status, 2);
  EXPECT_EQ(runShell("$GLIDERCC graph").status, 2);
}

}  // namespace
}  // namespace glider::tests
