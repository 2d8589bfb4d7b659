// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// accepts: GL9360 GL9361 GL9362
// A requirement that does not hold: check writes the run that breaks it, and sim flies that run on
// the mission as it is built, here and as the boards' binaries.

#include "tests/support/command.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <gmock/gmock.h>

namespace glider::tests {
namespace {

using testing::HasSubstr;

/// `upper` may be 3 m to 8 m: what breaks the first requirement needs one near an end.
const std::string kReplayed =
    "mission m\n"
    "param hold : time = 10 min in 5 min .. 20 min\n"
    "require exit within 60 min\n"
    "require never warm after cold\n"
    "require always depth <= 20 m\n"
    "require reach cold\n"
    "state warm\nbegin\n  flightprofile yo(5 m, 20 m, 26 deg, 26 deg)\n"
    "  sensors depth, temp, missiontime, statetime\n  events\n"
    "    case missiontime >= 30 min          exit\n"
    "    case statetime > hold && temp < 9 degC goto cold\nend\n"
    "state cold\nbegin\n  flightprofile yo(5 m, 10 m, 26 deg, 26 deg)\n"
    "  sensors depth, temp, statetime\n  events\n"
    "    case temp > 12 degC      goto warm\n"
    "    case statetime > 15 min  exit\nend\n";

class Replay : public testing::Test {
 protected:
  void SetUp() override {
    mission_ = folder_.write("m.mission", kReplayed).string();
    checked_ = runShell("$GLIDERCC check " + mission_ + " --traces " + runs());
  }

  [[nodiscard]] std::string runs() const { return (folder_.path() / "runs").string(); }
  [[nodiscard]] std::string trace(int requirement) const {
    return runs() + "/requirement-" + std::to_string(requirement) + "/trace.json";
  }
  Outcome replay(int requirement, const std::string& how) const {
    return runShell("$GLIDERCC sim " + mission_ + " --replay " + trace(requirement) + " -o " +
                    runs() + "/out " + how);
  }

  TemporaryFolder folder_;
  std::string mission_;
  Outcome checked_;
};

TEST_F(Replay, TheFolderOfACounterexampleIsEnough) {
  EXPECT_THAT(checked_.err,
              HasSubstr("`glidercc sim " + mission_ + " --replay " + runs() + "/requirement-"));
  const Outcome flown =
      runShell("$GLIDERCC sim " + mission_ + " --replay " + runs() + "/requirement-3");
  EXPECT_THAT(flown.out, HasSubstr("violates `require always depth <= 20 m`")) << flown.err;
}

TEST_F(Replay, TheSameViolationShowsInProcessAndOnTheHost) {
  EXPECT_EQ(checked_.status, 1);
  EXPECT_THAT(checked_.err, HasSubstr("[GL3110 requirement-broken]"));
  EXPECT_THAT(checked_.err, HasSubstr("2 counterexamples written"));
  for (const int requirement : {2, 3}) {
    for (const std::string how : {"", "--board host"}) {
      const Outcome flown = replay(requirement, how);
      EXPECT_EQ(flown.status, 1) << flown.err;
      EXPECT_THAT(flown.out, HasSubstr("the mission violates `require "));
      const std::string rows =
          slurp(std::filesystem::path(trace(requirement)).replace_filename("trace.csv"));
      EXPECT_THAT(flown.out,
                  HasSubstr("(" + std::to_string(std::ranges::count(rows, '\n') - 1) + " ticks)"));
    }
  }
  EXPECT_FALSE(std::filesystem::exists(trace(1))) << "proved";
  EXPECT_FALSE(std::filesystem::exists(trace(4))) << "proved";
}

TEST_F(Replay, TheSameViolationShowsOnTheBoards) {
  for (const std::string board : {"ts7800", "ts5500"}) {
    const Outcome flown = replay(2, "--board " + board);
    EXPECT_EQ(flown.status, 1) << flown.err;
    EXPECT_THAT(flown.out, HasSubstr(board + " followed the counterexample"));
  }
}

TEST_F(Replay, ACheckThatIsEndedWhileItWritesLeavesTheEarlierTrace) {
  const auto files = [&](const std::string& of) {
    return runShell("cd " + runs() + " && ls -A " + of).out;
  };
  const std::string folder = runs() + "/requirement-2/", before = slurp(trace(2));
  const std::string csv = slurp(folder + "trace.csv"), names = files("requirement-2");
  std::string other = kReplayed;
  other.replace(other.find("in 5 min"), 8, "in 6 min");
  (void)folder_.write("m.mission", other);
  // The file size limit ends it when trace.csv is written and report.html is not.
  const std::string again = "$GLIDERCC check " + mission_ + " --traces " + runs();
  EXPECT_GT(runShell("ulimit -f 100; " + again).status, 2);
  EXPECT_EQ(slurp(trace(2)), before);
  EXPECT_EQ(slurp(folder + "trace.csv"), csv);
  EXPECT_EQ(files("requirement-2"), names);
  EXPECT_EQ(runShell(again).status, 1);
  EXPECT_NE(slurp(folder + "trace.csv"), csv) << "another run";
  EXPECT_EQ(files("requirement-2"), names);
  EXPECT_EQ(files("."), "requirement-2\nrequirement-3\n") << "nothing beside them";
}

TEST_F(Replay, AFolderOfATraceThatHoldsOtherFilesIsNotTouched) {
  const auto notes = runs() + "/requirement-2/notes.txt";
  ASSERT_EQ(runShell("echo mine > " + notes).status, 0);
  const Outcome refused = runShell("$GLIDERCC check " + mission_ + " --traces " + runs());
  EXPECT_EQ(refused.status, 2);
  EXPECT_THAT(refused.err,
              HasSubstr("it contains `notes.txt`, which is not from a counterexample"));
  EXPECT_EQ(slurp(notes), "mine\n");
  EXPECT_EQ(runShell("$GLIDERCC sim " + mission_ + " -o " + runs() + "/requirement-3").status, 2)
      << "a flight does not take the place of a run";
  EXPECT_TRUE(std::filesystem::exists(trace(3)));
}

/// The vehicle of a counterexample has all that a mission may need.
TEST_F(Replay, MissionsThatNeedMoreOfTheVehicleFlyTheirTraces) {
  const std::string begin = R"(mission m
nap at most 4 min
require visit b within 2 h

state a
begin
  flightroute   )";
  const std::string end = R"(
  flightprofile yo(5 m, 20 m)
  sensors       missiontime, battery
  sample        fluorometer off
  events
    case battery < 11 V    exit
    case missiontime > 1 h goto b
end

state b
begin
  flightprofile surfaced
  sensors       statetime
  events
    case statetime > 20 min exit
end
)";
  for (const char* route : {"heading(90 deg)", "fixed_fin(5 deg)"}) {
    (void)folder_.write("m.mission", begin + route + end);
    const std::string traces = (folder_.path() / "t").string();
    EXPECT_EQ(runShell("$GLIDERCC check --traces " + traces + " " + mission_).status, 1);
    const Outcome flown =
        runShell("$GLIDERCC sim " + mission_ + " --replay " + traces + "/requirement-1");
    EXPECT_THAT(flown.out, HasSubstr("violates `require visit b")) << route << flown.err;
  }
}

TEST_F(Replay, AMissionThatWasFixedNoLongerFliesTheTrace) {
  std::string mended = kReplayed;
  mended.replace(mended.find("goto warm"), 9, "exit     ");
  mission_ = folder_.write("m.mission", mended).string();
  const Outcome flown = replay(2, "");
  EXPECT_EQ(flown.status, 0) << flown.err;
  EXPECT_THAT(flown.out, HasSubstr("holds in this flight"));
}

/// Parameters in units other than SI units, positions south and west, and truth values.
TEST_F(Replay, ParametersOfEveryKindGoAlong) {
  mission_ = folder_
                 .write("p.mission",
                        "mission p\n"
                        "param limit : pressure = 2 bar in 1 bar .. 3 bar\n"
                        "param least : charge = 50 Ah in 10 Ah .. 100 Ah\n"
                        "param south : latitude = 39 S\n"
                        "param quick : bool = false\n"
                        "param steep : angle = 26 deg in 20 deg .. 30 deg\n"
                        "where south < 10 S\n"
                        "require exit within 50 min\n"
                        "state a\nbegin\n  flightprofile yo(5 m, 20 m, steep, steep)\n"
                        "  sensors missiontime, pressure, lat\n  events\n"
                        "    case pressure > limit && lat < south && quick && least > 20 Ah stay\n"
                        "    case missiontime >= 40 min exit\nend\n")
                 .string();
  const Outcome checked = runShell("$GLIDERCC check " + mission_ + " --traces " + runs());
  EXPECT_THAT(checked.err, HasSubstr("1 counterexample written")) << checked.out;
  const Outcome flown = replay(1, "");
  EXPECT_EQ(flown.status, 1) << flown.err;
  EXPECT_THAT(flown.out, HasSubstr("the mission violates"));
}

TEST_F(Replay, OtherFilesAreRefused) {
  const auto text = folder_.write("text.json", "not JSON");
  const auto cut = folder_.write("cut.json", slurp(trace(2)).substr(0, 1000));
  const auto other = folder_.write("other.json", R"({"mission":"m","scenario":"","way":"","seed":0,
      "states":[],"columns":[{"name":"time","unit":"s"}],"rows":[1],"events":[]})");
  for (const auto& file : {text, cut}) {
    const Outcome refused =
        runShell("$GLIDERCC sim " + mission_ + " --replay " + file.string() + " -o " + runs());
    EXPECT_EQ(refused.status, 2);
    EXPECT_THAT(refused.err, HasSubstr("[GL9360 no-trace]"));
  }
  const Outcome flight =
      runShell("$GLIDERCC sim " + mission_ + " --replay " + other.string() + " -o " + runs());
  EXPECT_EQ(flight.status, 2);
  EXPECT_THAT(flight.err, HasSubstr("[GL9361 trace-not-of-mission]"));
  const Outcome missing = runShell("$GLIDERCC sim " + mission_ + " --replay /nowhere/trace.json");
  EXPECT_EQ(missing.status, 2);
}

// A run needs a program that is not this mission to go another way.
TEST_F(Replay, AnotherProgramIsFoundOut) {
  std::string other = kReplayed;
  other.replace(other.find("missiontime >= 30 min"), 21, "missiontime >= 4 min");
  const auto file = folder_.write("other.mission", other);
  const std::string binary = (folder_.path() / "other").string();
  ASSERT_EQ(runShell("$GLIDERCC build " + file.string() + " --target host -o " + binary).status, 0);
  const Outcome flown = runShell("$GLIDERCC sim " + mission_ + " --replay " + trace(2) + " --sbc " +
                                 binary + " -o " + runs());
  EXPECT_EQ(flown.status, 2);
  EXPECT_THAT(flown.err, HasSubstr("[GL9362 replay-differs]"));
}

/// A trace that was changed in one place is refused with what is wrong in it.
TEST_F(Replay, ATraceOfSomethingElseIsRefusedByWhatItLacks) {
  const std::string whole = slurp(trace(2));
  const auto refusal = [&](const std::string& from, const std::string& to) {
    std::string text = whole;
    const size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    text.replace(at == std::string::npos ? 0 : at, at == std::string::npos ? 0 : from.size(), to);
    const auto file = folder_.write("changed.json", text);
    const Outcome flown = runShell("$GLIDERCC sim " + mission_ + " --replay " + file.string() +
                                   " -o " + runs() + "/changed");
    EXPECT_EQ(flown.status, 2) << from << flown.out;
    return flown.err;
  };
  ASSERT_EQ(
      runShell("$GLIDERCC sim " + mission_ + " --replay " + trace(2) + " -o " + runs() + "/same")
          .status,
      1)
      << "as it is";
  EXPECT_THAT(refusal("\"requirement\":1", "\"requirement\":4"),
              HasSubstr("the mission has only 4 requirements"));
  EXPECT_THAT(refusal("\"requirement\":1,", ""), HasSubstr("it records a flight"));
  EXPECT_THAT(refusal("\"mission\":\"m\"", "\"mission\":\"n\""),
              HasSubstr("it is for mission `n`, but this is `m`"));
  EXPECT_THAT(refusal("\"missiontime\"", "\"mission_time\""), HasSubstr("it has no mission times"));
  EXPECT_THAT(refusal("\"sci_water_temp\"", "\"sci_water_cond\""),
              HasSubstr("it has no readings of `sci_water_temp`"));
}

}  // namespace
}  // namespace glider::tests
