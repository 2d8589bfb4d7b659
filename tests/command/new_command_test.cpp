// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// `glidercc new`: every template is a mission that checks clean, flies and explains itself.

#include "tests/support/command.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <gmock/gmock.h>
#include <sstream>
#include <string>
#include <vector>

namespace glider::tests {
namespace {

using testing::HasSubstr;

std::vector<std::string> templates() {
  std::vector<std::string> names;
  std::istringstream lines(runShell("$GLIDERCC new").out);
  for (std::string line; std::getline(lines, line);) {
    names.push_back(line.substr(0, line.find(' ')));
  }
  return names;
}

TEST(New, EveryTemplateChecksCleanAndFlies) {
  const auto names = templates();
  EXPECT_THAT(names, testing::IsSupersetOf({"holds", "hover", "mooring", "surface_on_event",
                                            "thermocline", "transect", "yo"}));
  for (const std::string& name : names) {
    const TemporaryFolder folder;
    const std::string here = "cd " + folder.path().string() + "; $GLIDERCC ";
    ASSERT_EQ(runShell(here + "new " + name).status, 0) << name;
    const Outcome checked =
        runShell(here + "check --strict --scenario default " + name + ".mission");
    EXPECT_EQ(checked.status, 0) << name << checked.err;
    EXPECT_EQ(checked.err, "") << name;
    const Outcome flown = runShell(here + "sim " + name + ".mission");
    EXPECT_EQ(flown.status, 0) << name << flown.err;
    EXPECT_THAT(flown.out, HasSubstr("→ end (exit")) << name;
    EXPECT_EQ(runShell(here + "fmt --check " + name + ".mission").status, 0) << name;
    EXPECT_THAT(slurp(folder.path() / (name + ".mission")), testing::StartsWith("# ")) << name;
  }
}

TEST(New, AMissionIsNamedAfterItsFile) {
  const TemporaryFolder folder;
  const std::string here = "cd " + folder.path().string() + "; $GLIDERCC ";
  EXPECT_EQ(runShell(here + "new yo survey.mission").status, 0);
  EXPECT_THAT(slurp(folder.path() / "survey.mission"), HasSubstr("\nmission survey\n"));
  EXPECT_EQ(runShell(here + "new yo 2nd-try.mission").status, 0);
  EXPECT_THAT(slurp(folder.path() / "2nd-try.mission"), HasSubstr("\nmission yo\n"));
  EXPECT_THAT(runShell(here + "new yo -").out, HasSubstr("\nmission yo\n"));
}

TEST(New, NothingIsOverwritten) {
  const TemporaryFolder folder;
  (void)folder.write("yo.mission", "mine");
  const Outcome outcome = runShell("cd " + folder.path().string() + "; $GLIDERCC new yo");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_THAT(outcome.err, HasSubstr("cannot write `yo.mission`: File exists [GL9002 "));
  EXPECT_EQ(slurp(folder.path() / "yo.mission"), "mine");
}

TEST(New, AnUnknownTemplateNamesTheNearest) {
  const Outcome outcome = runShell("$GLIDERCC new transekt");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_THAT(outcome.err, HasSubstr("did you mean `transect`?"));
}

}  // namespace
}  // namespace glider::tests
