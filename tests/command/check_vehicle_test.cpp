// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// `glidercc check --mi` and `--scenario`: what the vehicle's own mission file refuses.

#include "tests/support/command.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>
#include <string>

namespace glider::tests {
namespace {

using testing::HasSubstr;
using testing::Not;

class CheckVehicle : public ::testing::Test {
 protected:
  /// A mission that dives to 20 m at 26 deg for an hour.
  std::string mission(const std::string& head = "") const {
    return folder_
        .write("m.mission", "mission m\n" + head +
                                "state survey\nbegin\n  flightprofile yo(5 m, 20 m, 26 deg, 26 "
                                "deg)\n  sensors missiontime\n  events\n"
                                "    case missiontime >= 1 h exit\nend\n")
        .string();
  }
  std::string vehicle(const std::string& abend, const std::string& hookbeh) const {
    return folder_
        .write("v.mi", "behavior: abend\n" + abend + "behavior: hookbeh\n" + hookbeh +
                           "behavior: surface\nb_arg: start_when(enum) 1\n")
        .string();
  }
  Outcome check(const std::string& options, const std::string& head = "") const {
    return runShell("$GLIDERCC check " + options + " " + mission(head));
  }
  Outcome with(const std::string& abend, const std::string& hookbeh) const {
    return check("--mi " + vehicle(abend, hookbeh));
  }

  const TemporaryFolder folder_;
};

void expectError(const Outcome& outcome, const std::string& text) {
  EXPECT_EQ(outcome.status, 1) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr(text));
}

void expectFine(const Outcome& outcome) {
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.err, Not(HasSubstr("GL31")));
}

TEST_F(CheckVehicle, WhatHookbehRefusesIsAnError) {
  expectError(
      with("", "b_arg: max_depth(m) 15\n"),
      "m.mission:2:7: error: `survey` may command a depth of 20 m, but hookbeh refuses more "
      "than 15 m [GL3124 vehicle-refuses]");
  expectError(with("", "b_arg: max_pitch(rad) 0.4\n"),
              "`survey` may command a pitch of 26 deg, but hookbeh refuses more than 22.9 deg");
  expectError(with("", "b_arg: min_pitch(rad) 0.5\n"),
              "`survey` may command a pitch of 26 deg, but hookbeh refuses less than 28.6 deg");
  expectFine(with("", "b_arg: max_depth(m) 25\nb_arg: max_pitch(rad) 0.46\n"));
}

TEST_F(CheckVehicle, AnAvoidanceOfTheLibraryIsReportedWhereItIsUsed) {
  const auto above = [&](const std::string& height) {
    const auto file = folder_.write("above.mission",
                                    "mission m\nstate survey\nbegin\n  flightroute noheading\n"
                                    "  flightprofile yo_above(5 m, 20 m, above = " +
                                        height +
                                        ")\n  sensors missiontime, depth, altitude\n"
                                        "  events case missiontime >= 1 h exit\nend\n");
    return runShell("$GLIDERCC check --mi " + vehicle("", "b_arg: min_altitude(m) 5\n") + " " +
                    file.string());
  };
  const Outcome late = above("7 m");
  EXPECT_THAT(late.err, HasSubstr("above.mission:5:17: warning: the vehicle may not follow the "
                                  "mission: `yo_above` turns here only at less than 7 m"));
  EXPECT_THAT(late.err, HasSubstr("hint: give it 8 m or more: 5 m for"));
  EXPECT_THAT(above("8 m").err, Not(HasSubstr("GL3131"))) << "8 m is what the hint says";
}

TEST_F(CheckVehicle, AFinBeyondThatOfHookbehIsAnError) {
  const auto with_fin = [&](const std::string& hookbeh) {
    const auto fin = folder_.write("fin.mission",
                                   "mission m\nstate survey\nbegin\n"
                                   "  flightprofile yo(5 m, 20 m, 26 deg, 26 deg)\n"
                                   "  flightroute fixed_fin(-20 deg)\n  sensors missiontime\n"
                                   "  events case missiontime >= 1 h exit\nend\n");
    return runShell("$GLIDERCC check --mi " + vehicle("", hookbeh) + " " + fin.string());
  };
  expectError(with_fin("b_arg: max_fin(rad) 0.3\n"),
              "`survey` may command a fin angle of 20 deg, but hookbeh refuses more than 17.2 deg");
  expectFine(with_fin("b_arg: max_fin(rad) 0.35\n"));
  expectFine(with_fin(""));
}

TEST_F(CheckVehicle, APumpOrBatteryBeyondThatOfHookbehIsAnError) {
  const auto trimmed =
      folder_.write("trim.mission",
                    "mission m\nstate survey\nbegin\n  flightroute noheading\n"
                    "  flightprofile fixed_trim(-120 cc, 0.4 inch)\n  sensors depth\n"
                    "  events\n    case depth > 9 m || depth < -1 m exit\n    case missiontime >= "
                    "1 h exit\nend\n");
  const auto with_args = [&](const std::string& abend, const std::string& hookbeh) {
    return runShell("$GLIDERCC check --mi " + vehicle(abend, hookbeh) + " " + trimmed.string());
  };
  expectError(with_args("", "b_arg: max_pump(cc) 119\n"),
              "`survey` may command a pump volume of 120 cc, but hookbeh refuses more than 119 cc");
  expectError(with_args("", "b_arg: max_battery(in) 0.39\n"),
              "`survey` may command a battery position of 0.4 inch, but hookbeh refuses more than "
              "0.39 inch");
  EXPECT_EQ(
      with_args("", "b_arg: max_pump(cc) 120\nb_arg: max_battery(in) 0.4\n").err.find("GL3124"),
      std::string::npos);
}

/// Not `always` of a mission that has none.
TEST_F(CheckVehicle, OnlyWhatCommandsADepthIsNamed) {
  const Outcome outcome = with("", "b_arg: max_depth(m) -10\n");
  expectError(outcome, "`survey` may command a depth of 20 m, but hookbeh refuses more than -10 m");
  EXPECT_THAT(outcome.err, Not(HasSubstr("`always`")));
}

/// The bound may merely not have been found: that is not an error.
TEST_F(CheckVehicle, TheReportSaysThatAbendEndsAMissionWithoutAProvedEnd) {
  const std::string endless =
      folder_
          .write("endless.mission",
                 "mission m\nstate warm\nbegin\n  flightprofile surfaced\n  sensors temp\n"
                 "  events\n    case temp > 4 degC exit\nend\n")
          .string();
  const auto report = [&](const std::string& abend, const std::string& path) {
    const Outcome outcome =
        runShell("$GLIDERCC check --report --target host --mi " + vehicle(abend, "") + " " + path);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return outcome.out;
  };
  const std::string line =
      "\nthe mission has no proved end: abend aborts it 10 min 0 s after the vehicle's mission has "
      "begun (overtime in v.mi)\n";
  EXPECT_THAT(report("b_arg: overtime(s) 600\n", endless), HasSubstr(line));
  EXPECT_THAT(report("", endless), Not(HasSubstr("no proved end")));
  EXPECT_THAT(report("b_arg: overtime(s) 4000\n", mission()), Not(HasSubstr("no proved end")));
}

TEST_F(CheckVehicle, WhatAbendAbortsIsAnError) {
  expectError(with("b_arg: overdepth(m) 15\n", ""),
              "the vehicle aborts the mission: `survey` may command a depth of 20 m, and abend "
              "allows no more than 15 m (overdepth in v.mi) [GL3125 vehicle-aborts]");
  expectError(
      with("b_arg: overtime(s) 3000\n", ""),
      "the mission may last 1 h 0 min 20 s, and abend allows 50 min 0 s (overtime in v.mi)");
  expectError(with("b_arg: undervolts(volts) 20\n", ""),
              "and abend demands 20 V (undervolts in v.mi)");
  expectFine(
      with("b_arg: overdepth(m) 25\nb_arg: overtime(s) 3620\nb_arg: undervolts(volts) 10\n", ""));
  expectFine(
      with("b_arg: overdepth(m) -1\nb_arg: overtime(s) -1\nb_arg: undervolts(volts) -1\n", ""));
}

/// abend counts since the last fix or contact.
TEST_F(CheckVehicle, UnderWaterForLongerThanAbendAllows) {
  const std::string allowed =
      "and abend allows 50 min 0 s without a fix or contact "
      "(no_cop_tickle_for in v.mi)";
  const std::string limit = "b_arg: no_cop_tickle_for(sec) 3000\n";
  expectError(with(limit, ""),
              "the vehicle aborts the mission: the mission may stay under water for 1 h 0 min 20 "
              "s, " +
                  allowed);
  // After the exit it climbs, and waits for a fix.
  EXPECT_THAT(with("b_arg: no_cop_tickle_for(sec) 3620\n", "").err,
              HasSubstr("for 1 h 0 min 20 s, and then climb until it has a fix, and abend allows"));
  expectFine(with("b_arg: no_cop_tickle_for(sec) 4600\n", ""));
  EXPECT_THAT(with("b_arg: no_cop_tickle_for(sec) 4600\n", "b_arg: start_secs(sec) 1000\n").err,
              HasSubstr("GL3131"));
  expectFine(with("b_arg: no_cop_tickle_for(sec) -1\n", ""));
  const auto surfaces_after = [&](const std::string& time) {
    const auto file = folder_.write("up.mission",
                                    "mission m\nstate survey\nbegin\n"
                                    "  flightprofile yo(5 m, 20 m, 26 deg, 26 deg)\n"
                                    "  sensors missiontime, statetime\n  events\n"
                                    "    case statetime >= " +
                                        time +
                                        " goto up\nend\n"
                                        "state up\nbegin\n  flightprofile surfaced\n"
                                        "  sensors statetime\n  events\n"
                                        "    case missiontime >= 2 h exit\n"
                                        "    case statetime >= 20 min goto survey\nend\n");
    return runShell("$GLIDERCC check --mi " + vehicle(limit, "") + " " + file.string());
  };
  expectFine(surfaces_after("25 min"));
  // It comes up, and the bound on when may be far above what happens.
  const Outcome late = surfaces_after("55 min");
  EXPECT_EQ(late.status, 0) << late.err;
  EXPECT_THAT(late.err, HasSubstr("warning: the vehicle may not follow the mission"));
  EXPECT_THAT(late.err, HasSubstr(allowed));
}

/// A behaviour above hookbeh gets the fix.
TEST_F(CheckVehicle, TheVehicleItselfMayComeUpInTime) {
  const auto with_surface = [&](const std::string& seconds) {
    const auto file = folder_.write(
        "own.mi",
        "behavior: abend\nb_arg: no_cop_tickle_for(sec) 3000\n"
        "behavior: surface\nb_arg: start_when(enum) 12\nb_arg: when_secs(sec) " +
            seconds + "\nb_arg: end_action(enum) 1\nbehavior: hookbeh\nb_arg: max_depth(m) 30\n");
    return runShell("$GLIDERCC check --mi " + file.string() + " " + mission());
  };
  EXPECT_THAT(with_surface("1200").err, Not(HasSubstr("no_cop_tickle_for")));
  expectError(with_surface("2900"), "no_cop_tickle_for");
  const Outcome perhaps = with_surface("1000001");  // a parameter of the vehicle's mission
  EXPECT_THAT(perhaps.err, HasSubstr("warning: the vehicle may not follow the mission: the mission "
                                     "may stay under water for 1 h 0 min 20 s"));
}

/// How long it stays is not known where a reading alone leads up or down.
TEST_F(CheckVehicle, NothingIsKnownOfTheTimeUnderWater) {
  const auto file = folder_.write("up.mission",
                                  "mission m\nstate survey\nbegin\n"
                                  "  flightprofile yo(5 m, 20 m, 26 deg, 26 deg)\n"
                                  "  sensors battery\n  events\n"
                                  "    case battery < 11 V goto up\nend\n"
                                  "state up\nbegin\n  flightprofile surfaced\n"
                                  "  sensors battery\n  events\n"
                                  "    case battery > 14 V goto survey\n"
                                  "    case battery < 9 V exit\nend\n");
  EXPECT_THAT(runShell("$GLIDERCC check --mi " + vehicle("", "") + " " + file.string()).err,
              HasSubstr("nothing shows how long the mission stays under water, and abend allows "
                        "13 h 30 min 0 s without a fix or contact"));
}

TEST_F(CheckVehicle, AScenarioSaysWhereItStarts) {
  const std::string here = "assume start inside(39 N 74 W, 39 N 73 W, 40 N 73.5 W)\n";
  const std::string there = "assume start inside(49 N 74 W, 49 N 73 W, 50 N 73.5 W)\n";
  expectFine(check("--scenario default", here));
  expectError(
      check("--scenario default", there),
      "scenario `default` starts at 39 10.500 N 73 50.100 W, but the mission assumes `start "
      "inside(49 N 74 W");
  expectFine(check("", there));
}

TEST_F(CheckVehicle, AScenarioHasAMissionFile) {
  const auto deep =
      folder_.write("deep.mission",
                    "mission m\nstate survey\nbegin\n  flightprofile yo(5 m, 90 m, 26 "
                    "deg, 26 deg)\n  sensors missiontime\n  events\n    case "
                    "missiontime >= 1 h exit\nend\n");
  expectError(runShell("$GLIDERCC check --scenario default " + deep.string()), "GL3125");
  EXPECT_EQ(runShell("$GLIDERCC check " + deep.string()).status, 0);
}

TEST_F(CheckVehicle, OtherFilesAreRefused) {
  EXPECT_EQ(check("--mi none.mi").status, 2);
  EXPECT_EQ(check("--scenario none").status, 2);
  EXPECT_EQ(check("--mi " + folder_.write("a.mi", "behavior: surface\n").string()).status, 2);
}

/// The default scenario with more faults; a file of the folder.
std::filesystem::path scenarioWith(const TemporaryFolder& folder, const std::string& faults) {
  std::string scenario = slurp(std::string(GLIDER_SOURCE_DIR) + "/scenarios/default.toml");
  const std::string skeleton = "\"skeleton.mi\"";
  EXPECT_NE(scenario.find(skeleton), std::string::npos);
  scenario.replace(scenario.find(skeleton), skeleton.size(),
                   "\"" GLIDER_SOURCE_DIR "/scenarios/skeleton.mi\"");
  return folder.write("changed.toml", scenario + "\n" + faults);
}

/// A device that fails, and two states that send the vehicle to each other: nothing that a proof
/// sees.
TEST_F(CheckVehicle, AFlightInTheScenarioShowsWhatItsTextDoesNot) {
  const Outcome failed =
      check("--scenario " + scenarioWith(folder_, "[[faults.abort]]\nat_s = 100\n").string());
  EXPECT_EQ(failed.status, 0) << failed.err;
  EXPECT_THAT(failed.err, HasSubstr("MS_ABORT_"));
  EXPECT_THAT(failed.err, HasSubstr("[GL9370 flight-aborted]"));
  const auto flown = [&](const std::string& body) {
    const auto path = folder_.write("f.mission", "mission f\n" + body).string();
    return runShell("$GLIDERCC check --scenario default " + path);
  };
  const Outcome restless = flown(R"(
state a
begin
  flightprofile yo(5 m, 20 m, 26 deg, 26 deg)
  sensors       missiontime
  events
    case missiontime >= 1 h      exit
    case missiontime >= 5 min    goto b
end
state b
begin
  flightprofile yo(5 m, 25 m, 26 deg, 26 deg)
  sensors       statetime
  events
    case statetime >= 0 s goto a
end
)");
  EXPECT_EQ(restless.status, 0) << restless.err;
  EXPECT_THAT(restless.err, HasSubstr("on the mission changed its state 20 times within 5 min "
                                      "[GL9378 flight-unusual]"));
  EXPECT_THAT(restless.err, HasSubstr("see the flight with `glidercc sim "));
}

/// The command in the hint flies what `check` flew.
TEST_F(CheckVehicle, AFlightWithTheMissionFileOfTheVehicleIsSeenBySim) {
  const std::string own = vehicle("", "b_arg: max_depth(m) 60\n");
  const Outcome checked = check("--scenario default --duration 20min --mi " + own, "");
  EXPECT_THAT(checked.err, HasSubstr("had not ended"));
  const std::string begin = "see the flight with `glidercc ";
  const size_t from = checked.err.find(begin);
  ASSERT_NE(from, std::string::npos) << checked.err;
  const size_t at = from + begin.size();
  const std::string command = checked.err.substr(at, checked.err.find('`', at) - at);
  EXPECT_THAT(command, HasSubstr("--scenario default --mi " + own));
  EXPECT_EQ(checked.err.substr(at + command.size() + 1, 1), "\n");
  const Outcome flown = runShell("$GLIDERCC " + command + " -o " + (folder_.path() / "f").string());
  EXPECT_THAT(flown.out, HasSubstr("flown 1200 s"));
}

/// The SBC starts again afterwards, as in `sim`.
TEST_F(CheckVehicle, AFlightInAScenarioWithAPowerCutGoesOn) {
  const auto cut = scenarioWith(folder_, "[[faults.power]]\nfrom_s = 100\nto_s = 200\n");
  const Outcome flown =
      check("--scenario " + cut.string(), "assume no outage\nassume depth <= 40 m\n");
  EXPECT_EQ(flown.status, 0) << flown.err;
  EXPECT_THAT(flown.err, HasSubstr("there was no tick for more than 20 s; after an outage of the "
                                   "SBC from mission time 92 s to 200 s"));
  EXPECT_THAT(flown.err, HasSubstr("[GL5128 assumption-flown]"));
  EXPECT_THAT(flown.err, Not(HasSubstr("GL9378")));
}

// accepts: GL9378
TEST_F(CheckVehicle, AFlightInTheScenarioThatGoesWellSaysNothing) {
  const Outcome fine = check("--scenario default");
  EXPECT_EQ(fine.status, 0);
  EXPECT_EQ(fine.err, "");
  EXPECT_EQ(check("", "assume temp <= 15 degC\n").err, "") << "not flown";
  EXPECT_THAT(check("--scenario default", "assume temp <= 15 degC\n").err,
              HasSubstr("[GL5128 assumption-flown]"));
}

}  // namespace
}  // namespace glider::tests
