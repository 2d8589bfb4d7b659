// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/support/command.h"
#include "tests/support/replaced.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>
#include <string>

namespace glider::tests {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

const std::string kOld = R"(mission survey
require always depth <= 30 m
param limit : time = 30 min in 10 min .. 1 h
state look
begin
  flightprofile yo(5 m, 20 m, 26 deg, 26 deg)
  sensors       missiontime, depth, temp
  events
    case temp > 40 degC       goto report
    case missiontime >= limit goto report
end
state report
begin
  flightprofile surfaced
  sensors       statetime
  events
    case statetime >= 10 min exit
end
)";

Outcome diff(const std::string& before, const std::string& after, const std::string& options = "") {
  const TemporaryFolder folder;
  return runShell("$GLIDERCC diff " + options + " " + folder.write("old.mission", before).string() +
                  " " + folder.write("new.mission", after).string());
}

TEST(DiffCommand, CommentsAndNamesOfConstantsAreNoDifference) {
  const std::string same =
      replaced(replaced(kOld, "mission survey", "mission survey\n# deeper\nconst deepest = 20 m"),
               "yo(5 m, 20 m, 26 deg, 26 deg)", "yo(5 m,\n     deepest, 26 deg, 26 deg)");
  const Outcome outcome = diff(kOld, same);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "no difference in behaviour\n");
}

TEST(DiffCommand, AStateThatWasOnlyRenamedIsNamed) {
  const Outcome outcome = diff(kOld, replaced(kOld, "report", "home"));
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "names\n  `report` is now `home`\nno difference in behaviour\n");
}

TEST(DiffCommand, AProfileGuardsBoundsVerdictsAndTheFlight) {
  const Outcome outcome =
      diff(kOld, replaced(replaced(kOld, "20 m", "28 m"), "temp > 40 degC", "temp > 20 degC"));
  EXPECT_EQ(outcome.status, 1) << outcome.err;
  EXPECT_THAT(
      outcome.out,
      AllOf(HasSubstr(
                "state `look`\n"
                "  flightprofile: yo(5 m, 20 m, 26 deg, 26 deg) → yo(5 m, 28 m, 26 deg, 26 deg)\n"
                "  changed: case temp > 40 degC goto report → case temp > 20 degC goto report\n"),
            HasSubstr("bounds\n  commands lead at most this deep: 25 m → 33 m\n"),
            HasSubstr("requirements\n  require always depth <= 30 m: proved → refuted\n"),
            HasSubstr("a flight on which they part\n  scenario default, --seed 1: both do the same "
                      "until 0 s, in `look`\n"
                      "  old: commands descend(20 m, 26 deg), drift()\n"
                      "  new: commands descend(28 m, 26 deg), drift()\n"),
            Not(HasSubstr("state `report`"))));
}

TEST(DiffCommand, AGuardPartsTheFlightWhereItFires) {
  const Outcome outcome = diff(kOld, replaced(kOld, "temp > 40 degC", "missiontime > 1000 s"));
  EXPECT_EQ(outcome.status, 1) << outcome.err;
  EXPECT_THAT(
      outcome.out,
      AllOf(HasSubstr("both do the same until 100"), HasSubstr("s, in `look`\n  old: "),
            HasSubstr("new: goes to `report` and commands surface()"), HasSubstr("depth = ")));
}

TEST(DiffCommand, WhatNoScenarioShowsIsFoundWithRandomReadings) {
  const Outcome outcome = diff(kOld, replaced(kOld, "temp > 40 degC", "temp > 41 degC"));
  EXPECT_EQ(outcome.status, 1) << outcome.err;
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("random readings: both do the same until "),
                                 HasSubstr("old: goes to `report`"), HasSubstr("temp = 40.")));
}

TEST(DiffCommand, AddedRemovedAndMovedCasesAndStates) {
  const std::string after = replaced(
      replaced(replaced(kOld, "    case temp > 40 degC       goto report\n", ""),
               "    case missiontime >= limit goto report\n",
               "    case missiontime >= limit goto deep\n    case depth > 18 m goto report\n"),
      "state report",
      "state deep\nbegin\n  flightprofile yo(5 m, 22 m, 26 deg, 26 deg)\n"
      "  sensors statetime\n  events\n    case statetime > 1 min goto report\nend\n"
      "state report");
  const Outcome outcome = diff(kOld, after, "--no-flights");
  EXPECT_EQ(outcome.status, 1) << outcome.err;
  EXPECT_THAT(outcome.out,
              AllOf(HasSubstr("states\n  added: `deep`\n"),
                    HasSubstr("changed: case missiontime >= limit goto report → "
                              "case missiontime >= limit goto deep"),
                    HasSubstr("case depth > 18 m goto report"),
                    HasSubstr("the mission ends after at most: "), Not(HasSubstr("flight"))));
  const Outcome back = diff(after, kOld, "--no-flights");
  EXPECT_THAT(back.out, HasSubstr("states\n  removed: `deep`\n"));
}

TEST(DiffCommand, ParametersAndTheirRanges) {
  const Outcome outcome =
      diff(kOld, replaced(kOld, "= 30 min in 10 min .. 1 h", "= 20 min in 10 min .. 2 h"),
           "--no-flights");
  EXPECT_EQ(outcome.status, 1) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("parameters\n  `limit`: 1800 s in 600 s .. 3600 s → 1200 s in "
                                     "600 s .. 7200 s\n"));
}

/// They change no behaviour, but what is proved.
TEST(DiffCommand, AssumptionsAndWhatRestsOnThem) {
  const std::string under =
      replaced(kOld, "require", "assume temp <= 30 degC\nrequire never temp > 31 degC\nrequire");
  const std::string bare = replaced(under, "assume temp <= 30 degC\n", "");
  const Outcome lost = diff(under, bare);
  EXPECT_EQ(lost.status, 0) << lost.err;
  EXPECT_THAT(lost.out, HasSubstr("assumptions\n  assume temp <= 30 degC: no longer\n"));
  EXPECT_THAT(
      lost.out,
      HasSubstr("require never temp > 31 degC: proved (assuming `temp <= 30 degC`) → refuted"));
  const Outcome other = diff(under, replaced(under, "temp <= 30 degC", "temp <= 25 degC"));
  EXPECT_THAT(
      other.out,
      HasSubstr(
          "assumptions\n  assume temp <= 30 degC: no longer\n  assume temp <= 25 degC: new\n"));
  EXPECT_THAT(other.out, HasSubstr("require never temp > 31 degC: proved (assuming `temp <= 30 "
                                   "degC`) → proved (assuming `temp <= 25 degC`)"));
}

TEST(DiffCommand, ErrorsAreNotCompared) {
  const Outcome outcome = diff(kOld, replaced(kOld, "goto report", "goto nowhere"));
  EXPECT_EQ(outcome.status, 2);
  EXPECT_THAT(outcome.err, HasSubstr("[GL2001 unknown-state]"));
  EXPECT_EQ(runShell("$GLIDERCC diff /no/such.mission /no/other.mission").status, 2);
  EXPECT_EQ(runShell("$GLIDERCC diff /no/such.mission").status, 2);
}

}  // namespace
}  // namespace glider::tests
