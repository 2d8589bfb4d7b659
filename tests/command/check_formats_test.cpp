// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// glidercc check of several missions, for people, editors and CI.

#include "tests/support/command.h"
#include "tests/unit/report/sarif_rules.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>

namespace glider::tests {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string kFormatted = GLIDER_SOURCE_DIR "/missions/figure2.mission";
const std::string kFormatted5 = GLIDER_SOURCE_DIR "/missions/figure5.mission";
const std::string kFormattedWrong =
    "mission m\nstate s\nbegin\n  flightprofile surfaced;\n  events\n"
    "    case missiontime => 1 h exit\nend\n";

TEST(CheckFormats, SarifOfSeveralMissionsIsOneLog) {
  const TemporaryFolder folder;
  const std::string bad = folder.write("bad one.mission", kFormattedWrong).string();
  const Outcome outcome =
      runShell("$GLIDERCC check --format sarif " + kFormatted + " '" + bad + "' " + kFormatted5);
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.err, IsEmpty());
  const json log = json::parse(outcome.out);
  EXPECT_THAT(report::sarifFaults(log), IsEmpty());
  const json& run = log["runs"][0];
  EXPECT_EQ(run["invocations"][0]["executionSuccessful"], true);
  EXPECT_EQ(run["invocations"][0]["exitCode"], 1);
  bool found = false;
  for (const json& result : run["results"]) {
    if (result["ruleId"] == "GL1005") {
      found = true;
      EXPECT_EQ(result["locations"][0]["physicalLocation"]["region"]["startLine"], 6);
      EXPECT_THAT(
          std::string(result["locations"][0]["physicalLocation"]["artifactLocation"]["uri"]),
          HasSubstr("bad%20one.mission"));
      EXPECT_FALSE(result["fixes"].empty());
      const json& rule = run["tool"]["driver"]["rules"][size_t(result["ruleIndex"])];
      EXPECT_THAT(std::string(rule["help"]["markdown"]), HasSubstr("# GL1005"));
    }
  }
  EXPECT_TRUE(found) << outcome.out;
}

TEST(CheckFormats, JsonListsWhatIsFine) {
  const Outcome outcome = runShell("$GLIDERCC check --format json " + kFormatted);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.err, IsEmpty());
  const json mission = json::parse(outcome.out)["missions"][0];
  EXPECT_EQ(mission["ok"], true);
  EXPECT_EQ(mission["mission"], "sampleMission");
  EXPECT_EQ(mission["states"].size(), 3);
  EXPECT_EQ(mission["deepest_path"], json({"s1", "s2"}));
}

TEST(CheckFormats, AMissionThatIsNotThereDoesNotKeepTheOthersFromBeingChecked) {
  for (const char* format : {"text", "json", "sarif"}) {
    const Outcome outcome = runShell(std::string("$GLIDERCC check --format ") + format +
                                     " /none.mission " + kFormatted);
    EXPECT_EQ(outcome.status, 2) << format;
    EXPECT_THAT(outcome.err, HasSubstr("/none.mission")) << format;
    EXPECT_THAT(outcome.err, HasSubstr("GL9001")) << format;
  }
  const Outcome text = runShell("$GLIDERCC check /none.mission " + kFormatted);
  EXPECT_THAT(text.out, HasSubstr("figure2.mission: fine"));
  const Outcome sarif = runShell("$GLIDERCC check --format sarif /none.mission " + kFormatted);
  const json log = json::parse(sarif.out);
  EXPECT_THAT(report::sarifFaults(log), IsEmpty());
  EXPECT_EQ(log["runs"][0]["invocations"][0]["executionSuccessful"], false);
}

TEST(CheckFormats, TextOfSeveralMissions) {
  const TemporaryFolder folder;
  const std::string bad = folder.write("bad.mission", kFormattedWrong).string();
  const Outcome outcome = runShell("$GLIDERCC check " + bad + " " + kFormatted);
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.err, HasSubstr("bad.mission: 2 errors"));
  EXPECT_THAT(outcome.out, HasSubstr("figure2.mission: fine; mission sampleMission, 3 states"));
}

TEST(CheckFormats, TheOutputIsAFileThatIsNotAMission) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "findings.sarif").string();
  const Outcome outcome = runShell("$GLIDERCC check --format sarif -o " + file + " " + kFormatted);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, IsEmpty());
  EXPECT_THAT(report::sarifFaults(json::parse(slurp(file))), IsEmpty());
  const std::string mission = folder.write("m.mission", slurp(kFormatted)).string();
  const Outcome over = runShell("$GLIDERCC check -o " + mission + " " + mission);
  EXPECT_EQ(over.status, 2);
  EXPECT_THAT(over.err, HasSubstr("GL9350"));
  EXPECT_EQ(slurp(mission), slurp(kFormatted));
}

TEST(CheckFormats, UsageErrors) {
  EXPECT_EQ(runShell("$GLIDERCC check").status, 2);
  EXPECT_EQ(runShell("$GLIDERCC check --format xml " + kFormatted).status, 2);
  EXPECT_EQ(runShell("$GLIDERCC check --format json -o /none/x " + kFormatted).status, 2);
}

}  // namespace
}  // namespace glider::tests
