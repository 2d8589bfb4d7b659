// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// `glidercc plan`: what it prints and writes, and how it fails.

#include "tests/support/command.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <gmock/gmock.h>
#include <string>

namespace glider::tests {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

const std::string kState =
    "state fly\nbegin\n  flightroute heading(90 deg)\n  flightprofile yo(5 m, bottom, 26 deg, 26 "
    "deg)\n  sensors missiontime, depth, charge\n  events\n    case missiontime > hours "
    "exit\nend\n";

const std::string kAtASpeed =
    "state fly\nbegin\n  flightroute heading(90 deg)\n  flightprofile level(bottom, 1 m/s)\n"
    "  sensors missiontime, depth\n  events\n    case missiontime > hours exit\nend\n";

/// A day at most, within 70 Wh as the charge counts it.
const std::string kOpen =
    "mission afternoon\n"
    "pack 100 Ah at 14.4 V\n"
    "require always energyused <= 70 Wh\n"
    "choose bottom : length in 20 m .. 60 m by 20 m  # how deep\n"
    "choose hours : time in 2 h .. 24 h by 2 h at launch\n"
    "prefer greatest hours then endurance\n";

class PlanCommand : public ::testing::Test {
 protected:
  [[nodiscard]] Outcome glidercc(const std::string& arguments) const {
    return runShell("cd " + folder_.path().string() + " && $GLIDERCC " + arguments);
  }
  void write(const std::string& text) const { (void)folder_.write("m.mission", text + kState); }

  TemporaryFolder folder_;
};

// accepts: GL9383 GL9384 GL9385 GL9386 GL9390
TEST_F(PlanCommand, SaysWhatItChoosesAndWhatItRefuses) {
  write(kOpen);
  const Outcome plan = glidercc("plan m.mission");
  EXPECT_EQ(plan.status, 0) << plan.err;
  EXPECT_THAT(plan.out, HasSubstr("hours: 12 values from 2 h to 24 h"));
  EXPECT_THAT(plan.out, HasSubstr("chosen    bottom = 60 m\n          hours = 4 h\n"));
  EXPECT_THAT(plan.out, HasSubstr("proved    1 requirement\n"));
  EXPECT_THAT(plan.out, HasSubstr("`require always energyused <= 70 Wh` stays undecided"));
}

TEST_F(PlanCommand, WritesWhatItChoosesWhereOtherCommandsReadIt) {
  write(kOpen);
  EXPECT_EQ(glidercc("plan m.mission --write -q").status, 0);
  const std::string text = slurp(folder_.path() / "m.mission");
  EXPECT_THAT(text, HasSubstr("choose bottom : length = 60 m in 20 m .. 60 m by 20 m  # how deep"));
  EXPECT_THAT(text, HasSubstr("choose hours : time = 4 h in 2 h .. 24 h by 2 h at launch"));
  const Outcome check = glidercc("check --strict m.mission");
  EXPECT_EQ(check.status, 0) << check.err;
  // Again, from what is written now: the same.
  EXPECT_EQ(glidercc("plan m.mission --write -q").status, 0);
  EXPECT_EQ(slurp(folder_.path() / "m.mission"), text);
}

TEST_F(PlanCommand, DrawsTheFrontAndListsItAsJson) {
  write(kOpen);
  const Outcome plan = glidercc("plan m.mission --picture front.svg --format json");
  EXPECT_EQ(plan.status, 0) << plan.err;
  const json document = json::parse(plan.out);
  EXPECT_EQ(document["ways"], 36);
  EXPECT_EQ(document["chosen"]["values"]["hours"], "4 h");
  ASSERT_EQ(document["front"].size(), 2);
  EXPECT_EQ(document["front"][1]["values"]["hours"], "2 h");
  EXPECT_EQ(document["refused"][0]["ways"], 30);
  const std::string svg = slurp(folder_.path() / "front.svg");
  EXPECT_THAT(svg, HasSubstr("hours (h)"));
  EXPECT_THAT(svg, HasSubstr("energy at most (Wh)"));
  EXPECT_THAT(svg, HasSubstr("60 m, 4 h"));
}

TEST_F(PlanCommand, KeepsToTheVehiclesMissionFile) {
  write(
      "mission m\nconst hours = 2 h\nchoose bottom : length in 20 m .. 100 m by 20 m\n"
      "prefer greatest bottom\n");
  EXPECT_THAT(glidercc("plan m.mission").out, HasSubstr("bottom = 100 m"));
  // max_depth 60, and a turn goes deeper
  const Outcome plan = glidercc("plan m.mission --mi " GLIDER_SOURCE_DIR "/scenarios/skeleton.mi");
  EXPECT_THAT(plan.out, HasSubstr("bottom = 40 m")) << plan.err;
  EXPECT_THAT(plan.out, HasSubstr("[GL3124]"));
}

TEST_F(PlanCommand, SaysThatNothingKeepsAllPromises) {
  write(
      "mission m\npack 100 Ah at 14.4 V\nrequire exit within 1 h\n"
      "choose hours : time in 2 h .. 4 h\nconst bottom = 30 m\n");
  const Outcome plan = glidercc("plan m.mission --write");
  EXPECT_EQ(plan.status, 1);
  EXPECT_THAT(plan.out, HasSubstr("`require exit within 1 h` may be broken"));
  EXPECT_THAT(plan.err, HasSubstr("no way to choose keeps all that is required"));
  EXPECT_THAT(slurp(folder_.path() / "m.mission"), Not(HasSubstr("time =")));
}

TEST_F(PlanCommand, LeavesOutWhatTheMissionDoesNotAllow) {
  write(
      "mission m\nchoose hours : time in 2 h .. 4 h by 1 h\n"
      "choose bottom : length in 20 m .. 100 m by 40 m where bottom < hours * 5 mm/s\n"
      "prefer greatest bottom then least hours\n");
  const Outcome plan = glidercc("plan m.mission");
  EXPECT_THAT(plan.out, HasSubstr("hours = 4 h\n          bottom = 60 m")) << plan.err;
  EXPECT_THAT(plan.out, HasSubstr("5 ways: not allowed by line 3"));
}

/// What is written now does not matter, even if the range does not have it any more.
TEST_F(PlanCommand, StartsFromWhatIsOpen) {
  write(
      "mission m\nconst hours = 2 h\nchoose bottom : length = 55 m in 20 m .. 40 m by 10 m\n"
      "prefer greatest bottom\n");
  const Outcome plan = glidercc("plan m.mission --write");
  EXPECT_THAT(plan.out, HasSubstr("bottom = 40 m, before 55 m")) << plan.err;
  EXPECT_THAT(slurp(folder_.path() / "m.mission"), HasSubstr("length = 40 m in 20 m .. 40 m"));
}

/// An error that was corrected to read on is an error still.
TEST_F(PlanCommand, PlansNoTextWithErrors) {
  write(
      "mission m\nconst hours = 2 h\nconst x = 5 metres\n"
      "choose bottom : length in 20 m .. 40 m\n");
  const Outcome plan = glidercc("plan m.mission --write");
  EXPECT_EQ(plan.status, 1);
  EXPECT_THAT(plan.err, HasSubstr("[GL1030"));
  EXPECT_THAT(slurp(folder_.path() / "m.mission"), HasSubstr("length in 20 m"));
}

TEST_F(PlanCommand, KeepsAwayFromWhatHasNoValue) {
  write(
      "mission m\nconst hours = 2 h\nconst bottom = 30 m\n"
      "choose a : number in -2 .. 3 by 1\nprefer greatest sqrt(a)\n");
  const Outcome plan = glidercc("plan m.mission");
  EXPECT_THAT(plan.out, HasSubstr("a = 3\n")) << plan.err;
  EXPECT_THAT(plan.out, HasSubstr("2 ways: an error in line 5 [GL2043]"));
}

/// The end of a range that is not exactly a number of its unit, and scores that differ by rounding
/// only.
TEST_F(PlanCommand, RoundingDecidesNothing) {
  write(
      "mission m\nconst bottom = 30 m\n"
      "choose hours : time in 30 min .. 4.1 h by 6 min\nprefer greatest hours\n");
  EXPECT_THAT(glidercc("plan m.mission").out, HasSubstr("hours = 246 min\n"));
  write(
      "mission m\nconst hours = 2 h\nconst bottom = 30 m\nchoose a : number in 0.1 .. 0.9 by "
      "0.1\nchoose b : number in 0.1 .. 0.9 by 0.1 where a + b >= 0.8999\n"
      "prefer least (a + b) then greatest b\n");
  EXPECT_THAT(glidercc("plan m.mission").out, HasSubstr("a = 0.1\n          b = 0.8\n"));
}

TEST_F(PlanCommand, NeedsNoObjective) {
  (void)folder_.write("m.mission",
                      "mission m\nplatform lauv\nconst bottom = 10 m\n"
                      "choose hours : time in 2 h .. 4 h by 1 h\n" +
                          kAtASpeed);
  const Outcome plan = glidercc("plan m.mission");
  EXPECT_EQ(plan.status, 0) << plan.err;
  EXPECT_THAT(plan.out, HasSubstr("chosen    hours = 2 h\n"));
}

// expects: GL9390
TEST_F(PlanCommand, WritesNothingIntoATextThatHasChanged) {
  write(kOpen);
  const Outcome plan =
      runShell("cd " + folder_.path().string() +
               " && cp m.mission other && (sleep 0.05; echo '# new' >> m.mission) & "
               "cd " +
               folder_.path().string() + " && $GLIDERCC plan m.mission --write");
  const std::string text = slurp(folder_.path() / "m.mission");
  EXPECT_EQ(plan.status == 2, plan.err.find("[GL9390") != std::string::npos) << plan.err;
  if (plan.status == 2) {
    EXPECT_THAT(text, HasSubstr("# new"));
    EXPECT_THAT(text, Not(HasSubstr("time = ")));
  }
}

TEST_F(PlanCommand, RefusesWhatItCannotPlan) {
  write("mission m\nconst hours = 2 h\nconst bottom = 30 m\n");
  const Outcome nothing = glidercc("plan m.mission");
  EXPECT_EQ(nothing.status, 2);
  EXPECT_THAT(nothing.err, HasSubstr("leaves nothing open [GL9383"));

  write(
      "mission m\nchoose hours : time in 2 h .. 24 h by 1 min\n"
      "choose bottom : length in 20 m .. 100 m by 1 m\n");
  const Outcome much = glidercc("plan m.mission");
  EXPECT_EQ(much.status, 2);
  EXPECT_THAT(much.err, HasSubstr("there are 107,001 ways to choose what is left open"));
  EXPECT_THAT(much.err, HasSubstr("[GL9384"));

  // Nothing is known of what a LAUV takes in any sea.
  const std::string lauv =
      "mission m\nplatform lauv\nconst bottom = 10 m\n"
      "choose hours : time in 2 h .. 4 h\n";
  (void)folder_.write("m.mission", lauv + "prefer endurance\n" + kAtASpeed);
  EXPECT_THAT(glidercc("plan m.mission").err, HasSubstr("[GL9385"));
  (void)folder_.write("m.mission", lauv + "prefer greatest hours\n" + kAtASpeed);
  EXPECT_THAT(glidercc("plan m.mission").out, HasSubstr("hours = 4 h"));
  const Outcome drawn = glidercc("plan m.mission --picture front.svg");
  EXPECT_EQ(drawn.status, 2);
  EXPECT_THAT(drawn.err, HasSubstr("[GL9386"));

  write("mission m\nchoose hours : time in 2 h\nconst bottom = 30 m\n");
  EXPECT_EQ(glidercc("plan m.mission").status, 1);

  const Outcome missing = glidercc("plan other.mission");
  EXPECT_EQ(missing.status, 2);
}

}  // namespace
}  // namespace glider::tests
