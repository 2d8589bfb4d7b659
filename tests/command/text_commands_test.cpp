// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The commands that work on a mission's text or are text: fmt, fix, explain.

#include "tests/support/command.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <gmock/gmock.h>

namespace glider::tests {
namespace {

using testing::HasSubstr;

const std::string kTidy =
    "mission m\n\nstate s  # the only one\nbegin\n  flightprofile surfaced\n"
    "  sensors       missiontime\n  events\n    case missiontime > 1 h exit\nend\n";
const std::string kUntidy =
    "mission m\nstate s# the only one\nbegin flightprofile surfaced\nsensors missiontime\n"
    "events case missiontime>1h exit end\n";
const std::string kMistaken =
    "mission m\nstate s\nbegin\n  flightprofile surfaced;\n  sensors depth temp\n  events\n"
    "    case missiontime => 1 h && depth > 5 metres exit\nend\n";

TEST(Fmt, WritesInPlaceAndOnlyWhatChanges) {
  const TemporaryFolder folder;
  const auto untidy = folder.write("untidy.mission", kUntidy);
  const auto tidy = folder.write("tidy.mission", kTidy);
  const auto before = std::filesystem::last_write_time(tidy);
  const Outcome outcome = runShell("$GLIDERCC fmt " + untidy.string() + " " + tidy.string());
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.out + outcome.err, "");
  EXPECT_EQ(slurp(untidy), kTidy);
  EXPECT_EQ(std::filesystem::last_write_time(tidy), before);
}

TEST(Fmt, ALinkAndPermissionsStay) {
  const TemporaryFolder folder;
  const auto real = folder.write("real.mission", kUntidy);
  const auto link = folder.path() / "link.mission";
  std::filesystem::create_symlink("real.mission", link);
  std::filesystem::permissions(real, std::filesystem::perms::owner_all);
  EXPECT_EQ(runShell("$GLIDERCC fmt " + link.string()).status, 0);
  EXPECT_TRUE(std::filesystem::is_symlink(link));
  EXPECT_EQ(slurp(real), kTidy);
  EXPECT_EQ(std::filesystem::status(real).permissions(), std::filesystem::perms::owner_all);
}

TEST(Fmt, CheckNamesWhatWouldChange) {
  const TemporaryFolder folder;
  const auto untidy = folder.write("untidy.mission", kUntidy);
  const auto tidy = folder.write("tidy.mission", kTidy);
  const Outcome both = runShell("$GLIDERCC fmt --check " + untidy.string() + " " + tidy.string());
  EXPECT_EQ(both.status, 1);
  EXPECT_EQ(both.out, untidy.string() + "\n");
  EXPECT_EQ(slurp(untidy), kUntidy);
  const Outcome fine = runShell("$GLIDERCC fmt --check " + tidy.string());
  EXPECT_EQ(fine.status, 0);
  EXPECT_EQ(fine.out, "");
}

/// All but figure2.mission, which is as the paper prints it.
TEST(Fmt, TheMissionsThatComeWithItAreFormatted) {
  const Outcome outcome = runShell("cd " GLIDER_SOURCE_DIR
                                   "/missions; find . -name '*.mission' ! -name figure2.mission"
                                   " | sort | xargs $GLIDERCC fmt --check");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "");
}

TEST(Fmt, StandardInput) {
  const TemporaryFolder folder;
  const auto untidy = folder.write("untidy.mission", kUntidy);
  EXPECT_EQ(runShell("$GLIDERCC fmt - < " + untidy.string()).out, kTidy);
  EXPECT_EQ(runShell("cat " + untidy.string() + " | $GLIDERCC fmt -").out, kTidy);
  EXPECT_EQ(runShell("$GLIDERCC fmt - < " + untidy.string() + " | $GLIDERCC fmt --check -").status,
            0);
}

TEST(Fmt, TheDiffIsOneThatPatchApplies) {
  const TemporaryFolder folder;
  const auto untidy = folder.write("m", kUntidy + "\n\n// the end");
  const Outcome outcome =
      runShell("cd " + folder.path().string() +
               "; command -v patch >/dev/null || exit 77; cp m n; $GLIDERCC fmt "
               "--diff m > d; cmp m n || exit 5; patch -s m < d; cat m");
  if (outcome.status == 77) {
    GTEST_SKIP() << "there is no `patch` here";
  }
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.out, kTidy + "\n// the end\n");
  EXPECT_EQ(
      runShell("$GLIDERCC fmt " + untidy.string() + "; $GLIDERCC fmt --diff " + untidy.string())
          .out,
      "");
}

TEST(Fmt, AFileWithErrorsIsLeftAlone) {
  const TemporaryFolder folder;
  const auto mistaken = folder.write("mistaken.mission", kMistaken);
  const auto untidy = folder.write("untidy.mission", kUntidy);
  const Outcome outcome = runShell("$GLIDERCC fmt " + mistaken.string() + " " + untidy.string());
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.err, HasSubstr("mistaken.mission:4:25: error: "));
  EXPECT_EQ(slurp(mistaken), kMistaken);
  EXPECT_EQ(slurp(untidy), kTidy) << "the other file is still formatted";
}

TEST(Fmt, SystemErrorsExitWithTwo) {
  EXPECT_EQ(runShell("$GLIDERCC fmt").status, 2);
  const Outcome missing = runShell("$GLIDERCC fmt /nonexistent/m.mission");
  EXPECT_EQ(missing.status, 2);
  EXPECT_THAT(missing.err, HasSubstr("[GL9001 "));
  EXPECT_EQ(runShell("$GLIDERCC fmt /").status, 2);
}

TEST(Fix, FixesWhatIsCertainAndReportsTheRest) {
  const TemporaryFolder folder;
  const auto path = folder.write("m.mission", kMistaken);
  const Outcome outcome = runShell("$GLIDERCC fix " + path.string());
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  for (const char* line :
       {":4:25: fixed [GL1012 semicolon] ", ":5:17: fixed [GL1008 missing-comma] ",
        ":7:22: fixed [GL1005 wrong-comparison] ", ":7:42: fixed [GL1030 unknown-unit] "}) {
    EXPECT_THAT(outcome.out, HasSubstr(path.string() + line));
  }
  EXPECT_EQ(slurp(path),
            "mission m\nstate s\nbegin\n  flightprofile surfaced\n  sensors depth, temp\n  events\n"
            "    case missiontime >= 1 h && depth > 5 m exit\nend\n");
  const Outcome again = runShell("$GLIDERCC fix " + path.string());
  EXPECT_EQ(again.status, 0);
  EXPECT_EQ(again.out, path.string() + ": nothing to fix\n");
}

TEST(Fix, FixesThatTouchComeInTheNextRound) {
  const TemporaryFolder folder;
  std::string text = kTidy;
  text.replace(text.find("missiontime > 1 h"), 17, "temp > 5 && depth > 5 m && missiontime > 1 h");
  const auto path = folder.write("m.mission", text);
  EXPECT_EQ(runShell("$GLIDERCC fix " + path.string()).status, 0);
  EXPECT_THAT(slurp(path), HasSubstr("sensors       missiontime, temp, depth\n"));
}

TEST(Fix, DryRunWritesNothing) {
  const TemporaryFolder folder;
  const auto path = folder.write("m.mission", kMistaken);
  const Outcome outcome = runShell("$GLIDERCC fix --dry-run " + path.string());
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr(": would fix [GL"));
  EXPECT_THAT(outcome.out, testing::Not(HasSubstr(": fixed ")));
  EXPECT_THAT(outcome.out, HasSubstr("\n-  sensors depth temp\n"));
  EXPECT_THAT(outcome.out, HasSubstr("\n+  sensors depth, temp\n"));
  EXPECT_EQ(slurp(path), kMistaken);
}

TEST(Fix, WhatHasNoFixStaysAndIsReported) {
  const TemporaryFolder folder;
  std::string text = kTidy;
  text.replace(text.find("missiontime >"), 13, "misiontme => 5 m; >");
  const auto path = folder.write("m.mission", text);
  const Outcome outcome = runShell("$GLIDERCC fix " + path.string());
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.err, "");
  EXPECT_EQ(runShell("$GLIDERCC fix /nonexistent/m").status, 2);
  EXPECT_EQ(runShell("$GLIDERCC fix").status, 2);
}

TEST(Explain, ByIdNumberAndName) {
  const Outcome outcome = runShell("$GLIDERCC explain GL2007");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("# GL2007: "));
  EXPECT_THAT(outcome.out, HasSubstr("```mission GL2007\n"));
  for (const char* id : {"2007", "gl2007", "types-differ"}) {
    EXPECT_EQ(runShell(std::string("$GLIDERCC explain ") + id).out, outcome.out) << id;
  }
}

TEST(Explain, WithoutIdListsThemAll) {
  const Outcome outcome = runShell("$GLIDERCC explain");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out,
              testing::StartsWith("GL1001  unexpected-token              unexpected text\n"));
  EXPECT_THAT(outcome.out, HasSubstr("GL1004  assign-for-equal "));
  EXPECT_THAT(outcome.out, HasSubstr("GL9105  port-failed "));
}

// accepts: GL9310
TEST(Explain, AnUnknownIdNamesTheNearest) {
  for (const char* id : {"GL2016", "type-differ", "GL99999999999", "../GL2007"}) {
    const Outcome outcome = runShell(std::string("$GLIDERCC explain ") + id);
    EXPECT_EQ(outcome.status, 2) << id;
    EXPECT_THAT(outcome.err, HasSubstr("[GL9310 "));
    EXPECT_EQ(outcome.out, "");
  }
  EXPECT_THAT(runShell("$GLIDERCC explain GL2016").err, HasSubstr("GL2015"));
  EXPECT_THAT(runShell("$GLIDERCC explain type-differ").err, HasSubstr("GL2007 types-differ"));
}

}  // namespace
}  // namespace glider::tests
