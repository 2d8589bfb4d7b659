// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/support/command.h"
#include "tests/support/replaced.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>
#include <regex>
#include <string>

namespace glider::tests {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

const std::string kBriefMission = R"(# Looks & reports.
mission survey
require always depth <= 30 m
param limit : time = 30 min in 10 min .. 1 h   # of the search
state look
begin
  flightprofile yo(5 m, 20 m, 26 deg, 26 deg)
  sensors       missiontime, depth, temp every 20 s
  entry do log "<b>begin</b>" end
  events
    case temp > 20 degC       goto home
    case missiontime >= limit goto home
end
state home
begin
  flightprofile surfaced
  sensors       statetime
  events
    case statetime >= 10 min exit
end
)";

/// The page without its tags, and with each run of spaces as one.
std::string textOf(const std::string& page) {
  std::string text = page.substr(page.find("<body>"));
  text = std::regex_replace(text, std::regex("<svg[^]*</svg>"), "");
  text = std::regex_replace(text, std::regex("</?code>"), "");
  text = std::regex_replace(text, std::regex("<[^>]*>"), " ");
  for (const auto& [entity, sign] : {std::pair("&lt;", "<"), std::pair("&gt;", ">"),
                                     std::pair("&quot;", "\""), std::pair("&amp;", "&")}) {
    text = std::regex_replace(text, std::regex(entity), sign);
  }
  return std::regex_replace(text, std::regex("\\s+"), " ");
}

class BriefCommand : public testing::Test {
 protected:
  Outcome brief(const std::string& text, const std::string& options = "") {
    (void)folder_.write("survey.mission", text);
    return run("brief survey.mission " + options);
  }
  [[nodiscard]] Outcome run(const std::string& command) const {
    return runShell("cd " + folder_.path().string() + " && $GLIDERCC " + command);
  }
  [[nodiscard]] std::string page(const std::string& name = "survey-brief.html") const {
    return slurp(folder_.path() / name);
  }

  const TemporaryFolder folder_;
};

TEST_F(BriefCommand, ShowsTheWaypointsThatAMissionImports) {
  (void)folder_.write("goto_l10.ma",
                      "<start:waypoints>\n713.000 5433.500\n725.800 5418.00\n<end:waypoints>\n");
  const Outcome outcome = brief(R"(mission survey
import "goto_l10.ma" as track
state go
begin
  flightroute along(capture = 100 m, track = track)
  flightprofile surfaced
  sensors lat, lon, missiontime
  events
    case routedone || missiontime > 2 h exit
end
)");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(textOf(page()), AllOf(HasSubstr("along (track = track, capture = 100 m)"),
                                    HasSubstr("[54 33.500 N 7 13.000 E, 54 18.000 N 7 25.800 E]"),
                                    HasSubstr("from goto_l10.ma")));
}

TEST_F(BriefCommand, ShowsTheWholeMission) {
  const Outcome outcome = brief(kBriefMission);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "survey-brief.html: mission survey, 2 states\n");
  EXPECT_EQ(outcome.err, "");
  EXPECT_THAT(
      textOf(page()),
      AllOf(HasSubstr("File survey.mission, vehicle slocum"), HasSubstr("Looks & reports."),
            HasSubstr("Of 1 requirement: 1 proved."), HasSubstr("The mission ends after at most"),
            HasSubstr("at most 25 m deep"), HasSubstr("look – the mission starts here"),
            HasSubstr("missiontime, depth and temp every 20 s"), HasSubstr("logs “<b>begin</b>”"),
            HasSubstr("when temp > 20 degC: goes to home"),
            HasSubstr("when missiontime >= limit: goes to home"),
            HasSubstr("when statetime >= 10 min: ends the mission"),
            HasSubstr("limit time 30 min 10 min to 1 h of the search"),
            HasSubstr("proved: require always depth <= 30 m"), HasSubstr("unknown after")));
  EXPECT_THAT(page(), Not(HasSubstr("<b>begin")));
}

TEST_F(BriefCommand, IsTheSameEachTime) {
  ASSERT_EQ(brief(kBriefMission).status, 0);
  const std::string first = page();
  ASSERT_EQ(brief(kBriefMission, "-o again.html").status, 0);
  EXPECT_EQ(page("again.html"), first);
  EXPECT_EQ(brief(kBriefMission, "-o -").out, first);
}

TEST_F(BriefCommand, DigestsAreThoseOfTheFiles) {
  ASSERT_EQ(brief(kBriefMission, "--target ts7800").status, 0);
  ASSERT_EQ(run("build survey.mission --target ts7800").status, 0);
  const auto sum = [&](const std::string& file) {
    return runShell("cd " + folder_.path().string() + " && sha256sum " + file).out.substr(0, 64);
  };
  const std::string text = textOf(page());
  EXPECT_THAT(text, HasSubstr("survey.mission " + sum("survey.mission")));
  EXPECT_THAT(text, HasSubstr("survey-ts7800, as glidercc build --target ts7800 writes it " +
                              sum("survey-ts7800")));
  EXPECT_THAT(text,
              HasSubstr("the standard library " +
                        sum("$(dirname $GLIDERCC)/../share/glidercc/library/standard.mission")));
}

TEST_F(BriefCommand, AViolatedRequirementStandsOut) {
  const Outcome outcome = brief(replaced(kBriefMission, "<= 30 m", "<= 22 m"));
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.err, HasSubstr("GL3110"));
  EXPECT_THAT(textOf(page()),
              AllOf(HasSubstr("Do not fly: this mission violates 1 of its requirements."),
                    HasSubstr("violated: require always depth <= 22 m requirement violated: at "),
                    HasSubstr("a simulated flight violates it too: scenario")));
}

TEST_F(BriefCommand, AMissionWithErrorsHasNoPage) {
  const Outcome outcome = brief(replaced(kBriefMission, "goto home", "goto nowhere"));
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.err, HasSubstr("nowhere"));
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "survey-brief.html"));
}

TEST_F(BriefCommand, WarningsAreOnThePage) {
  const Outcome outcome =
      brief(replaced(kBriefMission, "state look", "var n : number = 0\nstate look"));
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(textOf(page()), AllOf(HasSubstr("There is 1 warning, listed below."),
                                    HasSubstr("line 5: n is a variable"), HasSubstr("GL2057")));
}

TEST_F(BriefCommand, ValuesAtLaunch) {
  EXPECT_EQ(brief(kBriefMission, "--set limit=20min").status, 0);
  EXPECT_THAT(textOf(page()), HasSubstr("limit time 30 min 10 min to 1 h 20 min of the search"));
  const Outcome outcome = brief(kBriefMission, "--set limit=2h -o other.html");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_THAT(outcome.err, HasSubstr("GL9052"));
  EXPECT_EQ(page("other.html"), "");
}

TEST_F(BriefCommand, TheSkeletonSaysWhenTheVehicleTakesOver) {
  (void)folder_.write("skeleton.mi",
                      "behavior: hookbeh\n  b_arg: silence_secs(sec) 100\nbehavior: surface\n  "
                      "b_arg: start_when(enum) 1\n");
  const Outcome outcome = brief(kBriefMission, "--skeleton skeleton.mi");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(textOf(page()), HasSubstr("the vehicle takes control within 2 min 28 s"));
}

TEST_F(BriefCommand, MissingCodeInCLeavesTheDigestOut) {
  const std::string text = replaced(kBriefMission, "state look",
                                    "extern function density(t: temperature): number in 0 .. 2\n"
                                    "state look");
  const Outcome outcome =
      brief(replaced(text, "temp > 20 degC ", "density(temp) > 1 || temp > 20 degC "));
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(textOf(page()), AllOf(HasSubstr("density"), HasSubstr("link it with --link FILE")));
}

TEST_F(BriefCommand, WhatCannotBeWrittenOrReadIsExitCode2) {
  EXPECT_EQ(brief(kBriefMission, "-o no/such/folder.html").status, 2);
  EXPECT_EQ(brief(kBriefMission, "--target nothing").status, 2);
  EXPECT_EQ(brief(kBriefMission, "--nonsense").status, 2);
  EXPECT_EQ(run("brief missing.mission").status, 2);
  const Outcome same = brief(kBriefMission, "-o survey.mission");
  EXPECT_EQ(same.status, 2);
  EXPECT_THAT(same.err, HasSubstr("GL9350"));
  EXPECT_EQ(page("survey.mission"), kBriefMission);
  EXPECT_EQ(run("brief --help").status, 0);
}

TEST_F(BriefCommand, WithoutChromiumThereIsNoPdf) {
  (void)folder_.write("survey.mission", kBriefMission);
  const Outcome outcome =
      runShell("cd " + folder_.path().string() +
               " && PATH=/nowhere $GLIDERCC brief survey.mission -o survey.pdf");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_THAT(outcome.err, HasSubstr("GL9377"));
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "survey.pdf"));
}

// accepts: GL9377
TEST_F(BriefCommand, ChromiumPrintsThePdf) {
  if (runShell("command -v chromium || command -v chromium-browser || command -v google-chrome")
          .status != 0) {
    GTEST_SKIP() << "there is no Chromium";
  }
  const Outcome outcome = brief(kBriefMission, "-o survey.pdf");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  const std::string pdf = page("survey.pdf");
  EXPECT_TRUE(pdf.starts_with("%PDF-")) << pdf.substr(0, 20);
  EXPECT_THAT(pdf, HasSubstr("/Type /Page\n"));
  if (runShell("command -v pdftotext").status != 0) {
    GTEST_SKIP() << "the text was not looked at: pdftotext (poppler-utils) is not installed";
  }
  const std::string text =
      runShell("cd " + folder_.path().string() + " && pdftotext survey.pdf -").out;
  EXPECT_THAT(text, AllOf(HasSubstr("survey"), HasSubstr("Sensors that it needs")));
}

TEST_F(BriefCommand, APositionIsOneArgument) {
  const Outcome outcome = brief(R"(mission survey
const south_east = 39 10.2 N 73 49.7 W
state first
begin
  flightprofile yo(4 m, 25 m, 26 deg, 26 deg)
  sensors       missiontime
  events
    case missiontime >= 8 s goto leg(south_east, 2)
end
state leg(corner: position, number: number)
begin
  flightroute   nav(corner)
  flightprofile yo(4 m, 25 m, 26 deg, 26 deg)
  sensors       lat, lon, statetime
  entry do log "leg", number end
  events
    case distance(corner) < 60 m || statetime > 1 h exit
end
)");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(textOf(page()), HasSubstr("goes to leg with corner = south_east and number = 2"));
}

/// Every name of a mission that comes with glidercc is on its page.
class BriefOfGallery : public testing::TestWithParam<const char*> {};

TEST_P(BriefOfGallery, HasEveryName) {
  const std::string path = std::string(GLIDER_SOURCE_DIR) + "/missions/" + GetParam();
  const Outcome outcome = runShell("$GLIDERCC brief -o - " + path);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  const std::string text = textOf(outcome.out);
  const std::string mission = slurp(path);
  const std::regex names(R"((?:^|\n)(?:state|param|const|var|mission)\s+(\w+))");
  for (std::sregex_iterator at(mission.begin(), mission.end(), names), end; at != end; ++at) {
    EXPECT_THAT(text, HasSubstr(" " + (*at)[1].str() + " ")) << path;
  }
  const std::regex cases(R"(\n\s*case ([\w .<>=!]*?) +(?:goto|call|return|exit|stay|do)\b)");
  for (std::sregex_iterator at(mission.begin(), mission.end(), cases), end; at != end; ++at) {
    EXPECT_THAT(text, HasSubstr("when " + (*at)[1].str())) << path;
  }
}

INSTANTIATE_TEST_SUITE_P(Missions, BriefOfGallery,
                         testing::Values("gallery/bloom.mission", "gallery/virtual_mooring.mission",
                                         "gallery/survey_box.mission", "figure2.mission"));

}  // namespace
}  // namespace glider::tests
