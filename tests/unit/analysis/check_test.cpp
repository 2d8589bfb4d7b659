// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Checking as a library: what a program sees that links it without the command.

#include "analysis/check/check.h"

#include "tests/support/command.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>
#include <string>
#include <vector>

namespace glider::analysis {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class Recorder final : public CheckObserver {
 public:
  void at(const std::string& work) override { works.push_back(work); }
  void show(const support::DiagnosticEngine& diagnostics,
            const support::SourceManager& /*sources*/) override {
    for (const support::Diagnostic& one : diagnostics.sorted()) {
      shown.push_back(one.message);
    }
  }
  std::vector<std::string> works, shown;
};

class CheckMission : public ::testing::Test {
 protected:
  CheckedFile check(const std::string& text, const CheckOptions& options = {}) {
    return checkMission(folder_.write("a.mission", text).string(), options, recorder_);
  }
  tests::TemporaryFolder folder_;
  Recorder recorder_;
};

const std::string kRefuted = R"(mission a
require exit within 50 min
state down
begin
  flightprofile yo(5 m, 25 m, 26 deg, 26 deg)
  sensors       missiontime
  events
    case missiontime >= 1 h exit
end
)";

TEST_F(CheckMission, TellsTheObserverEachStepThatTakesLong) {
  const CheckedFile file = check(kRefuted);
  EXPECT_EQ(file.found.path, folder_.path() / "a.mission");
  EXPECT_THAT(recorder_.works, ElementsAre("reading it", "checking cases and commands",
                                           "proving 1 of 1: require exit within 50 min"));
  EXPECT_TRUE(file.found.budgets.empty());
}

TEST_F(CheckMission, AReportAddsTheStepsOfTheReport) {
  CheckOptions options;
  options.report = true;
  options.targets = {"ts7800"};
  const CheckedFile file = check(kRefuted, options);
  ASSERT_EQ(file.found.budgets.size(), 2U) << "a board and the lines";
  EXPECT_EQ(file.found.budgets.back().of, "ts7800");
  EXPECT_EQ(recorder_.works.back(), "compiling it for the boards");
}

TEST_F(CheckMission, ShowsTheErrorsInAScenarioAndFails) {
  CheckOptions options;
  (void)folder_.write("skeleton.mi", "behavior: nonsense\n");
  options.scenario = folder_
                         .write("bad.toml", tests::slurp(std::string(GLIDER_SOURCE_DIR) +
                                                         "/scenarios/default.toml"))
                         .string();
  const CheckedFile file = check(kRefuted, options);
  ASSERT_TRUE(file.found.failure);
  ASSERT_FALSE(recorder_.shown.empty());
  EXPECT_THAT(recorder_.shown[0], HasSubstr("nonsense"));
  EXPECT_THAT(recorder_.works, ElementsAre("reading it")) << "the check ends where a step fails";
}

TEST_F(CheckMission, AMissionWithErrorsInItsTextIsNotProvedAbout) {
  const CheckedFile file = check("mission a\nstate down\nbegin\nend\n");
  EXPECT_FALSE(file.found.ok());
  EXPECT_FALSE(file.found.failure);
  EXPECT_THAT(recorder_.works, ElementsAre("reading it"));
}

TEST_F(CheckMission, AFileThatIsNotThereIsAFailure) {
  const CheckedFile file = checkMission("no/such.mission", {}, recorder_);
  ASSERT_TRUE(file.found.failure);
  EXPECT_FALSE(file.compilation);
}

}  // namespace
}  // namespace glider::analysis
