// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Missions of the vehicle's own: `glidercc mi` and `glidercc sim FILE.mi`.

#include "tests/support/command.h"
#include "tests/support/replaced.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>
#include <string>

namespace glider::tests {
namespace {

using testing::HasSubstr;
using testing::Not;

/// Odd as real files are: CRLF, tabs, comments, capitals, no line end.
const std::string kMiMission =
    "# a survey\r\nsensor: u_mission_param_a(X) 25   # deepest\r\n"
    "behavior: abend\r\n\tb_arg: overtime(sec) 7200\r\n"
    "behavior: surface\r\n\tb_arg: start_when(enum) 12\r\n\tb_arg: when_secs(s)\t1200 # comms\r\n"
    "behavior: surface\r\n    b_arg: start_when(enum) 1\r\n    b_arg: end_action(enum) 0\r\n"
    "behavior: set_heading\r\n b_arg: heading_value(X)  1.5\r\n"
    "behavior: Yo\r\n b_arg: args_from_file(enum) 7\r\n b_arg: num_half_cycles_to_do(nodim) 4\r\n"
    " b_arg: end_action(enum) 0\r\n"
    "behavior: sample\r\n b_arg: args_from_file(enum) 3";
const std::string kArguments =
    "behavior_name=yo\n<start:b_arg>\n b_arg: d_target_depth(m) 1000000\n"
    " b_arg: c_target_depth(m)   +3.0 # top\n<end:b_arg>\n";

class MiCommand : public ::testing::Test {
 protected:
  MiCommand() {
    (void)folder_.write("survey.mi", kMiMission);
    (void)folder_.write("yo07.ma", kArguments);
  }
  [[nodiscard]] Outcome glidercc(const std::string& line) const {
    return runShell("cd " + folder_.path().string() + " && $GLIDERCC " + line);
  }
  [[nodiscard]] std::string text(const std::string& file) const {
    return slurp(folder_.path() / file);
  }

  const TemporaryFolder folder_;
};

TEST_F(MiCommand, ReadsAutoexecAndDoesNotSayWhatTheSimulatorLacks) {
  (void)folder_.write("autoexec.mi",
                      "name unit_999\r\ninstalled gps\r\nuse science 0 1 2\n"
                      "sensor: F_MAX_WORKING_DEPTH(m) 98 # ours\n");
  const Outcome shown = glidercc("mi autoexec.mi");
  EXPECT_EQ(shown.status, 0);
  EXPECT_EQ(shown.err, "");
  EXPECT_THAT(shown.out, testing::ContainsRegex("sensor f_max_working_depth +98"));
  (void)folder_.write("typo.mi", "behavior: yo\n b_arg: d_target_dept(m) 20\n");
  EXPECT_THAT(glidercc("mi typo.mi").err, HasSubstr("[GL5104 "));
}

TEST_F(MiCommand, ListsTheValuesInForceAndWhereTheyAreFrom) {
  const Outcome shown = glidercc("mi survey.mi");
  EXPECT_EQ(shown.status, 0) << shown.err;
  EXPECT_THAT(shown.out, testing::ContainsRegex("overtime +7200 sec +survey.mi\n"));
  EXPECT_THAT(shown.out, testing::ContainsRegex("c_target_depth +3 m +yo07.ma"));
  EXPECT_THAT(shown.out, testing::ContainsRegex("d_target_depth +u_mission_param_a m +yo07.ma"));
  EXPECT_THAT(shown.err, HasSubstr("[GL5115 argument-file-missing]"));
  EXPECT_THAT(shown.err, HasSubstr("cannot find `sample03.ma`"));
}

TEST_F(MiCommand, ColumnsAreAsWideAsTheirLongestNameNeeds) {
  (void)folder_.write(
      "long.mi",
      "sensor: u_a(X) 1\nbehavior: set_heading\n b_arg: heading_value(X) -7350.123456\n"
      "behavior: sensors_in\n b_arg: c_science_all_on_enabled_for_this_test(sec) 4\n"
      " b_arg: u_battery_time(some_long_unit) 1000001\n");
  (void)folder_.write("autoexec.mi", "sensor: f_one(m) 98\nsensor: f_two(m) 98\n");
  const Outcome shown = glidercc("mi long.mi");
  EXPECT_EQ(shown.out,
            "sensor u_a                                                1 X               long.mi\n"
            "below these the 2 settings of autoexec.mi\n"
            "\n"
            "set_heading\n"
            "  heading_value                                -7350.123456 X               long.mi\n"
            "\n"
            "sensors_in\n"
            "  c_science_all_on_enabled_for_this_test                  4 sec             long.mi\n"
            "  u_battery_time                          u_mission_param_b some_long_unit  long.mi\n")
      << shown.err;
}

TEST_F(MiCommand, SaysWhatAFileOfAnotherKindIsAndWhichCommandReadsIt) {
  (void)folder_.write("fine.mission", "mission fine\n");
  struct Expected {
    std::string line, what, hint;
  };
  const std::string vehicles = "is a mission of the vehicle's own, not one in the mission language";
  const std::string arguments = "is an argument file of the vehicle's own missions, not a mission";
  for (const Expected& row :
       {Expected{"check survey.mi", "`survey.mi` " + vehicles,
                 "`glidercc mi survey.mi` reads it, and `glidercc sim survey.mi` flies it"},
        Expected{"build survey.mi", vehicles, "glidercc mi"},
        Expected{"fmt survey.mi", vehicles, ""}, Expected{"fix survey.mi", vehicles, ""},
        Expected{"graph survey.mi", vehicles, ""},
        Expected{"check yo07.ma", "`yo07.ma` " + arguments,
                 "`glidercc mi MISSION.mi` shows its values"},
        Expected{"sim yo07.ma", arguments, ""}, Expected{"mi yo07.ma", arguments, ""},
        Expected{"fmt yo07.ma", arguments, ""},
        Expected{"mi fine.mission", "is a mission in the mission language",
                 "`glidercc check fine.mission` checks it"}}) {
    const Outcome refused = glidercc(row.line);
    EXPECT_EQ(refused.status, 2) << row.line;
    EXPECT_THAT(refused.err, HasSubstr("[GL9368 not-this-language]")) << row.line;
    EXPECT_THAT(refused.err, HasSubstr(row.what)) << row.line;
    EXPECT_THAT(refused.err, HasSubstr(row.hint)) << row.line;
    EXPECT_EQ(refused.err.find("[GL", refused.err.find("[GL") + 1), std::string::npos)
        << "no other error: " << refused.err;
  }
  // Names are often in capitals.
  (void)folder_.write("SURVEY.MI", kMiMission);
  EXPECT_EQ(glidercc("mi SURVEY.MI").status, 0);
  EXPECT_THAT(glidercc("check SURVEY.MI").err, HasSubstr("[GL9368 "));
  EXPECT_EQ(text("survey.mi"), kMiMission);
  EXPECT_THAT(glidercc("mi survey.mi").err, Not(HasSubstr("GL9368")));  // accepts: GL9368
}

TEST_F(MiCommand, ErrorsInItAreThoseOfTheMission) {
  (void)folder_.write("bad.mi", "behavior: yo\n b_arg: d_target_dept(m) 20\n");
  const Outcome bad = glidercc("sim bad.mi");
  EXPECT_EQ(bad.status, 2);
  EXPECT_THAT(bad.err, HasSubstr("the mission `bad.mi` has errors: 1"));
  EXPECT_THAT(bad.err, Not(HasSubstr("skeleton mission")));
}

/// The water of the default scenario is about 80 m deep.
TEST_F(MiCommand, AFlightIntoTheBottomDidNotGoWell) {
  (void)folder_.write("deep.mi",
                      "behavior: abend\n b_arg: overtime(s) 900\n b_arg: samedepth_for(s) -1\n"
                      "behavior: set_heading\n b_arg: heading_value(X) 1\nbehavior: yo\n b_arg: "
                      "d_target_depth(m) 100\n b_arg: d_target_altitude(m) -1\n");
  const Outcome flown = glidercc("sim deep.mi -o deep");
  EXPECT_EQ(flown.status, 1) << flown.out;
  EXPECT_THAT(flown.err, HasSubstr("[GL9376 bottom-touched]"));
  EXPECT_THAT(text("deep/flight.json"), HasSubstr("GL9376"));
  EXPECT_THAT(text("deep/flight.json"), HasSubstr("\"wentWell\": false"));
  EXPECT_THAT(text("deep/events.csv"), HasSubstr("\"bottom\""));
}

TEST_F(MiCommand, ChangesOneNumberAndNoOtherByte) {
  struct Expected {
    std::string edit, file, from, to;
  };
  for (const Expected& row :
       {Expected{"abend.overtime=3600", "survey.mi", "7200", "3600"},
        Expected{"surface.when_secs=90.5", "survey.mi", "1200", "90.5"},
        Expected{"surface#2.end_action=2", "survey.mi", "end_action(enum) 0\r\nbehavior: set",
                 "end_action(enum) 2\r\nbehavior: set"},
        Expected{"sensor.u_mission_param_a=30", "survey.mi", "25", "30"},
        Expected{"SAMPLE.args_from_file=-1", "survey.mi", "args_from_file(enum) 3",
                 "args_from_file(enum) -1"},
        Expected{"yo.c_target_depth=4", "yo07.ma", "+3.0", "4"}}) {
    (void)folder_.write("survey.mi", kMiMission);
    (void)folder_.write("yo07.ma", kArguments);
    const Outcome changed = glidercc("mi survey.mi --set " + row.edit);
    EXPECT_EQ(changed.status, 0) << changed.err;
    EXPECT_EQ(text("survey.mi"),
              row.file == "survey.mi" ? replaced(kMiMission, row.from, row.to) : kMiMission)
        << row.edit;
    EXPECT_EQ(text("yo07.ma"),
              row.file == "yo07.ma" ? replaced(kArguments, row.from, row.to) : kArguments)
        << row.edit;
  }
}

TEST_F(MiCommand, ChangesSeveralAtOnceAndShowsThemFirst) {
  const std::string sets = " --set surface.when_secs=60 --set abend.overtime=100000";
  const Outcome shown = glidercc("mi survey.mi --diff" + sets);
  EXPECT_EQ(shown.status, 0) << shown.err;
  EXPECT_THAT(shown.out, HasSubstr("100000"));
  EXPECT_EQ(text("survey.mi"), kMiMission) << "nothing is written";
  EXPECT_EQ(glidercc("mi survey.mi" + sets).status, 0);
  EXPECT_EQ(text("survey.mi"), replaced(replaced(kMiMission, "7200", "100000"), "1200", "60"));
}

TEST_F(MiCommand, RefusesWhatIsNotThere) {
  for (const char* edit : {"yo.when_secs=3", "surface#3.when_secs=3", "climb.depth=3"}) {
    const Outcome refused = glidercc("mi survey.mi --set " + std::string(edit));
    EXPECT_EQ(refused.status, 2) << edit;
    EXPECT_THAT(refused.err, HasSubstr("no file gives")) << edit;
  }
  for (const char* edit : {"yo", "yo.depth", "=3", "yo.depth=deep", "yo.depth=nan", "yo#0.a=1",
                           "yo.=3", "yo.depth=3m", "'yo.depth='"}) {
    const Outcome refused = glidercc("mi survey.mi --set " + std::string(edit));
    EXPECT_EQ(refused.status, 2) << edit;
    EXPECT_THAT(refused.err, HasSubstr("is not BEHAVIOUR.ARGUMENT=NUMBER")) << edit;
  }
  EXPECT_EQ(glidercc("mi nothing.mi").status, 2);
  EXPECT_EQ(glidercc("mi survey.mi --diff").status, 2);
  (void)folder_.write("bad.mi", "behavior: yo\n b_arg: d_target_dept(m) 3\n");
  const Outcome bad = glidercc("mi bad.mi");
  EXPECT_EQ(bad.status, 1);
  EXPECT_THAT(bad.err, HasSubstr("did you mean `d_target_depth`?"));
  EXPECT_EQ(text("survey.mi"), kMiMission);
}

TEST_F(MiCommand, SimFliesItWithoutAnSbc) {
  const Outcome flown = glidercc("sim survey.mi -o flight");
  EXPECT_EQ(flown.status, 0) << flown.out << flown.err;
  EXPECT_THAT(flown.out, HasSubstr("survey.mi"));
  EXPECT_THAT(flown.out, HasSubstr("yo_5: dive_to over, half cycle 1"));
  EXPECT_THAT(flown.out, Not(HasSubstr("abort")));
  EXPECT_THAT(flown.err, Not(HasSubstr("GL9376")));  // accepts: GL9376
  EXPECT_THAT(text("flight/flight.json"), HasSubstr("survey.mi"));
  const Outcome bad = glidercc("sim nothing.mi");
  EXPECT_EQ(bad.status, 2);
  EXPECT_THAT(bad.err, HasSubstr("nothing.mi"));
}

}  // namespace
}  // namespace glider::tests
