// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Values that a pilot gives or reads: times of parameters, arguments of the vehicle's missions, the
// quantity that colours a picture.

#include "tests/support/command.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>
#include <string>

namespace glider::tests {
namespace {

using testing::HasSubstr;
using testing::Not;

/// A mission with parameters of two dimensions.
std::string missionWithTimes() {
  return "mission storm\nparam storm_hours: time = 6 h in 1 h .. 24 h\n"
         "param pause: time = 90 s in 30 s .. 10 min\n"
         "param deepest: length = 20 m in 10 m .. 30 m\n"
         "state s\nbegin\n  flightprofile yo(5 m, deepest, 26 deg, 26 deg)\n"
         "  sensors missiontime\n  events\n    case missiontime > storm_hours + pause exit\nend\n";
}

TEST(Values, ATimeIsShownInTheUnitInWhichItIsAWholeNumber) {
  const TemporaryFolder folder;
  const std::string mission = folder.write("m.mission", missionWithTimes()).string();
  const std::string rows = runShell("$GLIDERCC params " + mission + " --set storm_hours=90min").out;
  EXPECT_THAT(rows, testing::ContainsRegex("storm_hours +time +6 h +1 h to 1 day +90 min\n"));
  EXPECT_THAT(rows, testing::ContainsRegex("pause +time +90 s +30 s to 10 min\n"));
  EXPECT_THAT(rows, testing::ContainsRegex("deepest +length +20 m +10 m to 30 m\n"));
}

/// As it is written in the mission, on the computer and on board.
TEST(Values, ATimeOfTheCalendarIsSetAndShownAsOne) {
  const TemporaryFolder folder;
  const std::string mission = folder
                                  .write("m.mission",
                                         "mission m\nparam begins: time = 2027-03-01T00:00Z\n"
                                         "param lasts: time = 3 h 30 min in 1 h .. 6 h\n"
                                         "state s\nbegin\n  flightprofile yo(5 m, 20 m)\n"
                                         "  sensors missiontime, m_present_time\n  events\n"
                                         "    case utc > begins exit\n"
                                         "    case missiontime > lasts exit\nend\n")
                                  .string();
  const std::string set = " --set begins=2028-01-01T06:30Z";
  const std::string rows = runShell("$GLIDERCC params " + mission + set).out;
  EXPECT_THAT(rows, HasSubstr("2027-03-01T00:00Z"));
  EXPECT_THAT(rows, HasSubstr("2028-01-01T06:30Z\n"));
  EXPECT_THAT(rows, HasSubstr("3 h 30 min"));
  const std::string file = folder.write("p", "begins = 2028-01-01T06:30Z # UTC\n").string();
  EXPECT_EQ(runShell("$GLIDERCC params " + mission + " --parameters " + file).out, rows);
  EXPECT_THAT(runShell("$GLIDERCC params " + mission + " --set begins=tomorrow").err,
              HasSubstr("write it as `begins=2027-03-01T00:00Z`, in UTC"));
  const std::string program = folder.path().string() + "/m";
  ASSERT_EQ(runShell("$GLIDERCC build -q " + mission + " -o " + program).status, 0);
  EXPECT_THAT(runShell(program + " --help").err, HasSubstr("  begins = 2027-03-01T00:00Z\n"));
  EXPECT_THAT(runShell(program + " --port /nonexistent" + set).err, HasSubstr("/nonexistent"));
}

TEST(Values, ATimeWithoutAUnitIsNamedInSeconds) {
  const TemporaryFolder folder;
  const std::string params =
      "$GLIDERCC params " + folder.write("m.mission", missionWithTimes()).string() + " --set ";
  const std::string err = runShell(params + "storm_hours=8").err;
  EXPECT_THAT(err, HasSubstr("`storm_hours` cannot be `8`, which is 8 s: outside its range, 1 h to "
                             "1 day [GL9052 "));
  EXPECT_THAT(err,
              HasSubstr("a number alone is in seconds: write the unit, as in `storm_hours=8h`"));
  EXPECT_THAT(err, Not(HasSubstr("ddmm.mmmm"))) << "it is not a position";
  const std::string length = runShell(params + "deepest=8").err;
  EXPECT_THAT(length, HasSubstr("`deepest` cannot be `8`: outside its range, 10 m to 30 m"));
  EXPECT_THAT(length, Not(HasSubstr("seconds")));
}

/// A number that counts one thing is not another.
TEST(Values, AParameterWithAUnitTakesNoOther) {
  const TemporaryFolder folder;
  const std::string text =
      "mission bloom\nparam low: number = 2.5 ug/L in 0 .. 10 ug/L\nparam factor: number = 2\n"
      "state s\nbegin\n  flightprofile yo(5 m, 20 m, 26 deg, 26 deg)\n"
      "  sensors missiontime, chlorophyll\n  events\n    case chlorophyll > factor * low exit\n"
      "    case missiontime > 1 h exit\nend\n";
  const std::string mission = folder.write("m.mission", text).string();
  const std::string params = "$GLIDERCC params " + mission;
  EXPECT_THAT(runShell(params + " --set 'low=3 ug/L'").out,
              testing::ContainsRegex("low +plain number +2.5 ug/L +0 ug/L to 10 ug/L +3 ug/L\n"));
  EXPECT_THAT(runShell(params + " --set low=3").out, HasSubstr("3 ug/L"));
  for (const char* wrong : {"3 uM", "3uM", "3 %"}) {
    const std::string set = " --set 'low=" + std::string(wrong) + "'";
    EXPECT_THAT(runShell(params + set).err, HasSubstr("write a value with a unit: ug/L")) << wrong;
    const std::string file = folder.write("p.txt", "low = " + std::string(wrong)).string();
    EXPECT_EQ(runShell(params + " --parameters " + file).status, 2) << wrong;
  }
  EXPECT_EQ(runShell(params + " --set factor=3%").status, 0);
  EXPECT_EQ(runShell(params + " --set factor=3uM").status, 0);
  // The text of the IR keeps the unit.
  const std::string ir =
      folder.write("m.ir", runShell("$GLIDERCC build " + mission + " --emit ir -o - ").out)
          .string();
  EXPECT_THAT(runShell("$GLIDERCC params " + ir + " --set 'low=3 uM'").err,
              HasSubstr("write a value with a unit: ug/L"));
}

TEST(Values, AMisspeltArgumentOfTheVehiclesMissionIsNamed) {
  const TemporaryFolder folder;
  const std::string mi =
      "$GLIDERCC mi " +
      folder
          .write("m.mi", "behavior: yo\n  b_arg: d_target_depth(m) 20\nsensor: u_max_depth(m) 30\n")
          .string() +
      " --diff --set ";
  EXPECT_THAT(runShell(mi + "yo.d_target_dept=30").err,
              HasSubstr("no file gives `yo.d_target_dept` a value; did you mean "
                        "`yo.d_target_depth`?"));
  EXPECT_THAT(runShell(mi + "yoo.d_target_depth=30").err,
              HasSubstr("did you mean `yo.d_target_depth`?"));
  EXPECT_THAT(runShell(mi + "sensor.u_max_dept=30").err,
              HasSubstr("did you mean `sensor.u_max_depth`?"));
  EXPECT_THAT(runShell(mi + "yo.start_when=2").err, HasSubstr("; add a line for it first"));
}

TEST(Values, APictureIsNotColouredByWhatWasNotMeasured) {
  const TemporaryFolder folder;
  const std::string sim = "cd " + folder.path().string() +
                          "; $GLIDERCC sim " GLIDER_SOURCE_DIR "/missions/figure2.mission -o f ";
  const Outcome outcome = runShell(sim + "--picture a.svg --colour-by chlorophyll");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_THAT(outcome.err, HasSubstr("note: the flight has no reading of `chlorophyll`"));
  EXPECT_EQ(runShell(sim + "--picture b.svg").err, "");
  EXPECT_EQ(slurp(folder.path() / "a.svg"), slurp(folder.path() / "b.svg"));
  EXPECT_EQ(runShell(sim + "--picture c.svg --colour-by temp").err, "");
}

}  // namespace
}  // namespace glider::tests
