// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// `-` for standard input, --strict, and what `fix` says of a mission that it cannot fix.

#include "tests/support/command.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <gmock/gmock.h>
#include <string>

namespace glider::tests {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

const std::string kGiven = GLIDER_SOURCE_DIR "/missions/figure2.mission";

/// Its proof refuses it: GL3104. Its text has nothing to fix.
const std::string kRefused =
    "mission m\nstate s\nbegin\n  flightprofile yo(5 m, 3000 m, 26 deg, 26 deg)\n"
    "  sensors missiontime\n  events\n    case missiontime > 5 min exit\nend\n";

TEST(StandardInput, IsChecked) {
  const Outcome file = runShell("$GLIDERCC check " + kGiven);
  const Outcome outcome = runShell("$GLIDERCC check - < " + kGiven);
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.out, "standard input" + file.out.substr(kGiven.size()));
  const Outcome wrong = runShell("printf 'mission m\nstate s begin end\n' | $GLIDERCC check -");
  EXPECT_EQ(wrong.status, 1);
  EXPECT_THAT(wrong.err, StartsWith("standard input:2:"));
}

TEST(StandardInput, IsDrawn) {
  EXPECT_EQ(runShell("$GLIDERCC graph - -o - < " + kGiven).out,
            runShell("$GLIDERCC graph " + kGiven + " -o -").out);
  const TemporaryFolder folder;
  EXPECT_EQ(runShell("cd " + folder.path().string() + "; $GLIDERCC graph - < " + kGiven +
                     " >/dev/null; ls")
                .out,
            "mission.svg\n");
}

TEST(StandardInput, IsFixedToStandardOutput) {
  const Outcome outcome = runShell("sed 's/ && / and /' " + kGiven + " | $GLIDERCC fix -");
  EXPECT_EQ(outcome.out, slurp(kGiven));
  EXPECT_EQ(runShell("$GLIDERCC fix - < " + kGiven + " 2>/dev/null").out, slurp(kGiven));
}

TEST(FixOfARefusedMission, SaysThatErrorsRemain) {
  const TemporaryFolder folder;
  const std::string mission = folder.write("m.mission", kRefused).string();
  const Outcome check = runShell("$GLIDERCC check " + mission);
  ASSERT_EQ(check.status, 1) << "the mission is no longer refused";
  const Outcome outcome = runShell("$GLIDERCC fix " + mission);
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.out, "");
  EXPECT_THAT(outcome.err, HasSubstr("[GL31"));
  EXPECT_THAT(outcome.err, testing::EndsWith(mission + ": nothing that can be fixed automatically; "
                                                       "1 error remains\n"));
  EXPECT_EQ(slurp(mission), kRefused);
}

/// A mission that checks without an error; with `what` before its state.
std::string missionWith(const std::string& what, const std::string& sensors = "missiontime") {
  return "mission m\n" + what +
         "\nstate s\nbegin\n  flightprofile yo(5 m, 20 m, 26 deg, 26 deg)\n"
         "  sensors " +
         sensors + "\n  events\n    case missiontime > 5 min exit\nend\n";
}

TEST(Strict, WarningsAndUndecidedRequirementsAreFailures) {
  const TemporaryFolder folder;
  const auto check = [&](const std::string& text, const std::string& options) {
    const std::string mission = folder.write("m.mission", text).string();
    return runShell("$GLIDERCC check " + options + " " + mission);
  };
  EXPECT_EQ(check(missionWith(""), "--strict").status, 0);
  const std::string proved = missionWith("require exit within 10 min");
  EXPECT_EQ(check(proved, "--strict").status, 0);
  // A promise that the time for proofs does not suffice for.
  const std::string promise = missionWith("require always depth < 500 m", "missiontime, depth");
  const Outcome undecided = check(promise, "--timeout 0.001");
  if (undecided.out.find("0 of 1 requirements proved") != std::string::npos) {
    EXPECT_EQ(undecided.status, 0);
    EXPECT_EQ(check(promise, "--timeout 0.001 --strict").status, 1);
  }
  const std::string warned = missionWith("var unused: number = 0");
  ASSERT_THAT(check(warned, "").err, HasSubstr("warning: "));
  EXPECT_EQ(check(warned, "").status, 0);
  EXPECT_EQ(check(warned, "--strict").status, 1);
  EXPECT_EQ(check(warned, "--strict --format json").status, 1);
}

TEST(Strict, OfABuildAndACampaign) {
  const TemporaryFolder folder;
  // The checks of its structure, which each command makes, warn: `b` is never entered.
  (void)folder.write("m.mission", missionWith("") +
                                      "state b\nbegin\n  flightprofile surfaced\n"
                                      "  sensors missiontime\n  events\n"
                                      "    case missiontime > 1 h exit\nend\n");
  const auto run = [&](const std::string& words) {
    return runShell("cd " + folder.path().string() + "; $GLIDERCC " + words);
  };
  EXPECT_THAT(run("build m.mission").err, HasSubstr("warning: "));
  EXPECT_TRUE(std::filesystem::remove(folder.path() / "m-host"));
  EXPECT_EQ(run("build --strict m.mission").status, 1);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "m-host"));
  const std::string campaign = "campaign m.mission --flights 2 --boards 0";
  EXPECT_EQ(run(campaign).status, 0);
  EXPECT_EQ(run(campaign + " --strict").status, 1);
}

}  // namespace
}  // namespace glider::tests
