// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What `glidercc sim` says at the end of a flight, and the folder that it leaves.

#include "tests/support/command.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <gmock/gmock.h>
#include <set>

namespace glider::tests {
namespace {

using testing::HasSubstr;
using testing::Not;

class Sim : public ::testing::Test {
 protected:
  /// A mission that dives to `deepest` for five minutes and reads `sensor`.
  void mission(const std::string& deepest = "20 m", const std::string& sensor = "depth",
               const std::string& head = "") const {
    (void)folder_.write("m.mission", "mission m\n" + head +
                                         "param w : position = 39.175 N 73.83 W\nstate s\nbegin\n  "
                                         "flightroute nav(w)\n  flightprofile yo(5 m, " +
                                         deepest + ", 26 deg, 26 deg)\n  sensors missiontime, " +
                                         sensor +
                                         "\n  events\n    case missiontime >= 5 min exit\nend\n");
  }
  [[nodiscard]] Outcome run(const std::string& arguments) const {
    return runShell("cd " + folder_.path().string() + " && " + arguments);
  }
  [[nodiscard]] std::set<std::string> namesIn(const std::string& name) const {
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder_.path() / name)) {
      names.insert(entry.path().filename().string());
    }
    return names;
  }
  [[nodiscard]] nlohmann::json summary() const {
    return nlohmann::json::parse(slurp(folder_.path() / "f" / "flight.json"), nullptr, false);
  }

  const TemporaryFolder folder_;
};

const std::set<std::string> kFiles = {"events.csv", "flight.json", "report.html", "trace.csv"};

/// Every flight of it would count as a violation.
TEST_F(Sim, ACampaignOfAMissionLongerThanTheScenarioIsRefused) {
  mission();
  std::string text = slurp(folder_.path() / "m.mission");
  const std::string when = "missiontime >= 5 min";
  const auto campaign = [&](const std::string& condition) {
    std::string changed = text;
    changed.replace(changed.find(when), when.size(), condition);
    (void)folder_.write("m.mission", changed);
    return run(
        "$GLIDERCC campaign m.mission --flights 2 --fault none --boards 0 --scenario figure5");
  };
  const Outcome refused = campaign("missiontime >= 20 h");
  EXPECT_EQ(refused.status, 1) << refused.out;
  EXPECT_THAT(refused.err, HasSubstr("does not end within the 2 h 0 min 0 s that scenario "
                                     "`figure5` lasts: it may last 20 h 0 min 20 s [GL9387"));
  EXPECT_THAT(refused.err, HasSubstr("hint: fly longer with `--duration 1240min`"));
  EXPECT_EQ(refused.out, "") << "no flight is flown";
  const Outcome endless = campaign("depth > 500 m");
  EXPECT_EQ(endless.status, 1) << endless.out;
  EXPECT_THAT(endless.err, HasSubstr("lasts [GL9387"));
  // accepts: GL9387
  const Outcome flown = campaign("missiontime >= 30 min");
  EXPECT_EQ(flown.status, 0) << flown.err;
  EXPECT_THAT(flown.err, Not(HasSubstr("GL9387")));
}

/// After the return the condition of the call is still true.
TEST_F(Sim, AMissionThatCallsAgainAndAgainIsReported) {
  (void)folder_.write("m.mission", R"(mission m
state look
begin
  flightprofile dive_to(15 m, 26 deg)
  sensors       missiontime
  events
    case missiontime >= 20 min exit
    case profiledone           call note
end
state note
begin
  flightprofile dive_to(15 m, 26 deg)
  sensors       statetime
  events
    case statetime >= 4 s return
end
)");
  const Outcome flown = run("$GLIDERCC sim m.mission -o f");
  EXPECT_EQ(flown.status, 1) << flown.err;
  EXPECT_THAT(flown.err, HasSubstr("on the mission changed its state 20 times within 5 min "
                                   "[GL9378 flight-unusual]"));
  EXPECT_THAT(run("$GLIDERCC check m.mission").err, HasSubstr("[GL3141 call-repeats]"));
}

/// The reason of a transition gives a time as UTC, with its date for `utc`.
/// A note for the vehicle holds 60 bytes. Here its values are the same in each tick, two statements
/// have one text, and one has no values.
TEST_F(Sim, AllValuesOfALogArrive) {
  (void)folder_.write("m.mission", R"(mission m
state s
begin
  flightprofile yo(5 m, 20 m, 26 deg, 26 deg)
  sensors       missiontime, depth
  events
    case missiontime >= 5 min exit
    case missiontime > 4 min do
      log "short", 5
      log "a text without values that is longer than the sixty bytes of a note"
      log "scan", 1.23456789012, 2.34567890123, 3.45678901234, 4.56789012345, 5.67890123456
      log "scan", 1.1, 2.2, 3.3, 4.4, 5.5
    end stay
end
)");
  EXPECT_EQ(run("$GLIDERCC sim m.mission -o f").status, 0);
  const std::string events = slurp(folder_.path() / "f" / "events.csv");
  const auto count = [&](const std::string& what) {
    size_t found = 0;
    for (size_t at = events.find(what); at != std::string::npos; at = events.find(what, at + 1)) {
      ++found;
    }
    return found;
  };
  const size_t ticks = count("\"short 5\"");
  EXPECT_GT(ticks, 10U);
  EXPECT_EQ(count("\"scan 1.23456789012 2.34567890123 3.45678901234 4.56789012345 5.67890123456\""),
            ticks);
  EXPECT_EQ(count("\"scan 1.1 2.2 3.3 4.4 5.5\""), ticks);
  EXPECT_EQ(count("\"a text without values that is longer than the sixty bytes of"), ticks);
}

TEST_F(Sim, TimesOfReasonsAreUtc) {
  (void)folder_.write("m.mission", R"(mission m
state a
begin
  flightprofile yo(5 m, 20 m, 26 deg, 26 deg)
  sensors missiontime
  events
    case missiontime > 1 min && timeofday >= 0 h goto b
end
state b
begin
  flightprofile yo(5 m, 20 m, 26 deg, 26 deg)
  sensors missiontime, statetime
  events
    case statetime > 1 min && utc > 2001-01-01T00:00Z exit
end
)");
  const Outcome flown = run("$GLIDERCC sim m.mission -o f");
  const std::string events = slurp(folder_.path() / "f" / "events.csv");
  EXPECT_THAT(events,
              testing::ContainsRegex("m_present_time [0-2][0-9]:[0-5][0-9]:[0-5][0-9] UTC"));
  EXPECT_THAT(events, testing::ContainsRegex(
                          "m_present_time 20[0-9-]* [0-2][0-9]:[0-5][0-9]:[0-5][0-9] UTC"));
}

/// Of each kind: a start elsewhere, a current, readings out of a range and gone too long.
TEST_F(Sim, AFlightThatBreaksAnAssumptionWarns) {
  const std::pair<const char*, const char*> kBroken[] = {
      {"start inside(49 N 74 W, 49 N 73 W, 50 N 73.5 W)", "s, the mission begins at 39 10."},
      {"start distance(39 10.5 N 73 49.8 W) <= 30 m", "431 m from the place that it names"},
      {"depth <= 15 m", "in state `s`"},
      {"depth in 0 m .. 15 m", "in state `s`"},
      {"gpslat in 10 N .. 20 N", "in state `s`"},
      {"known sci_oxy4_oxygen every 1 min", "`sci_oxy4_oxygen` was unknown for more than 1 min"}};
  for (const auto& [assumed, how] : kBroken) {
    mission("20 m", "depth, gpslat, sci_oxy4_oxygen", std::string("assume ") + assumed + "\n");
    const Outcome flown = run("rm -rf f; $GLIDERCC sim m.mission -o f");
    EXPECT_EQ(flown.status, 1) << assumed << flown.err;
    EXPECT_THAT(flown.err, HasSubstr("m.mission:2:1: warning: this flight breaks the assumption: "
                                     "at mission time "))
        << assumed;
    EXPECT_THAT(flown.err, HasSubstr(how)) << assumed;
    EXPECT_THAT(flown.err, HasSubstr("[GL5128 assumption-flown]"));
  }
}

/// The tick after the restart ends the outage: the flight is not watched further, but that is seen.
/// On board it is a note, sent to the vehicle once.
TEST_F(Sim, APowerCutBreaksAnAssumptionAboutOutages) {
  mission("20 m", "depth", "assume no outage\nassume depth in -1 m .. 40 m\n");
  std::string scenario = slurp(std::string(GLIDER_SOURCE_DIR) + "/scenarios/default.toml");
  const std::string skeleton = "\"skeleton.mi\"";
  ASSERT_NE(scenario.find(skeleton), std::string::npos);
  scenario.replace(scenario.find(skeleton), skeleton.size(),
                   "\"" GLIDER_SOURCE_DIR "/scenarios/skeleton.mi\"");
  (void)folder_.write("cut.toml", scenario + "\n[[faults.power]]\nfrom_s = 100\nto_s = 200\n");
  const Outcome flown = run("$GLIDERCC sim m.mission --scenario cut.toml -o f");
  EXPECT_EQ(flown.status, 1) << flown.err;
  EXPECT_THAT(flown.err, HasSubstr("m.mission:2:1: warning: this flight breaks the assumption: at "
                                   "mission time "));
  EXPECT_THAT(flown.err, HasSubstr("there was no tick for more than 20 s; after an outage of the "
                                   "SBC from mission time 92 s to 200 s"));
  EXPECT_THAT(flown.err, Not(HasSubstr("m.mission:3:1")));
  const std::string events = slurp(folder_.path() / "f" / "events.csv");
  const size_t note = events.find("assumption broken: no outage");
  EXPECT_NE(note, std::string::npos) << events;
  EXPECT_EQ(events.find("assumption broken", note + 1), std::string::npos) << events;
}

// accepts: GL5128
TEST_F(Sim, AFlightWithinItsAssumptionsIsFine) {
  mission("20 m", "depth, gpslat",
          "assume start inside(39 N 74 W, 39 N 73 W, 40 N 73.5 W)\nassume start depth <= 3 m\n"
          "assume no outage\nassume current <= 1 m/s\nassume depth in -1 m .. 40 m\n"
          "assume depth changes <= 1 m/s\n");
  const Outcome flown = run("$GLIDERCC sim m.mission -o f");
  EXPECT_EQ(flown.status, 0) << flown.err;
}

/// The vehicle goes slightly deeper than the command.
TEST_F(Sim, AFlightThatViolatesARequirementWarns) {
  mission("20 m", "depth", "require never depth > 20.2 m\nrequire visit s at most 1 times\n");
  const Outcome flown = run("$GLIDERCC sim m.mission -o f");
  EXPECT_EQ(flown.status, 1) << flown.err;
  EXPECT_THAT(flown.err,
              HasSubstr("m.mission:2:1: warning: this flight violates the requirement: at "
                        "mission time "));
  EXPECT_THAT(flown.err, HasSubstr("in state `s` [GL5127 requirement-flown]"));
  EXPECT_THAT(flown.err, Not(HasSubstr("m.mission:3:1")));
  EXPECT_EQ(summary().at("wentWell"), false);
}

/// A promise with a monitor says how; one that is met says nothing. accepts: GL5127
TEST_F(Sim, AMonitorSaysHowAFlightViolatesItsPromise) {
  mission("20 m", "depth", "require visit s at least 2 times within 4 min\n");
  EXPECT_THAT(run("$GLIDERCC sim m.mission -o f").err,
              HasSubstr("in state `s`, 4 min had passed, and `s` had been visited fewer than 2 "
                        "times [GL5127"));
  mission("20 m", "depth", "require visit s at least 1 times within 4 min\n");
  EXPECT_EQ(run("$GLIDERCC sim m.mission -o f").err, "");
}

const char* const kTimed =
    "require exit within 1 h\nrequire surfaces every 3 h\nrequire visit s at least 2 times "
    "within 4 h\nrequire patrol s every 3 h\nrequire whenever depth > 2 m then missiontime > 2 h "
    "within 3 h\nrequire always depth < 100 m\n";

/// What a flight was too short to show is not said to be kept.
TEST_F(Sim, WhatAFlightWasTooShortForIsNotDecided) {
  mission("20 m", "depth", kTimed);
  const Outcome flown = run("$GLIDERCC sim m.mission -o f --duration 2min");
  EXPECT_EQ(flown.status, 0) << flown.err;
  EXPECT_THAT(flown.out, HasSubstr("note: not decided, the flight ended before: `require exit "
                                   "within 1 h`, `require surfaces every 3"));
  std::vector<std::string> verdicts;
  const auto judged = summary();
  for (const auto& one : judged.at("requirements")) {
    verdicts.push_back(one.at("verdict"));
  }
  EXPECT_THAT(verdicts, testing::ElementsAre("not decided", "not decided", "not decided",
                                             "not decided", "not decided", "held"));
  EXPECT_THAT(slurp(folder_.path() / "f" / "report.html"),
              HasSubstr(R"("verdict":"not decided","words":"the flight ended before")"));
}

/// A mission without time has not ended when its time has passed.
TEST_F(Sim, AMissionThatHangsBreaksWhatItOwesInItsTime) {
  mission("20 m", "depth", kTimed);
  (void)folder_.write("stuck.toml",
                      "name = \"stuck\"\nskeleton = \"skeleton.mi\"\nduration_s = 7200\n"
                      "[start]\nlatitude_deg = 39.175\nlongitude_deg = -73.835\n"
                      "[[faults.stuck]]\nfrom_s = 60\n");
  const Outcome flown = run("$GLIDERCC sim m.mission --scenario stuck.toml -o f");
  EXPECT_EQ(flown.status, 1) << flown.err;
  EXPECT_THAT(flown.err, HasSubstr("m.mission:2:1: warning: this flight violates the requirement: "
                                   "at mission time 360"));
  EXPECT_THAT(flown.err, HasSubstr("the mission made its last tick at mission time "));
  const auto requirements = summary().at("requirements");
  EXPECT_EQ(requirements.at(0).at("verdict"), "violated");
  EXPECT_EQ(requirements.at(1).at("verdict"), "held") << "the vehicle is at the surface";
  EXPECT_EQ(requirements.at(2).at("verdict"), "not decided");
}

TEST_F(Sim, ACampaignCountsFlightsThatViolateARequirement) {
  mission("20 m", "depth", "require never depth > 20.2 m\nrequire visit s within 1 h\n");
  const Outcome flown =
      run("$GLIDERCC campaign m.mission --flights 6 --fault none --boards 0 --csv c.csv");
  EXPECT_THAT(flown.out,
              HasSubstr("m.mission: `require never depth > 20.2 m`: violated in 6 of 6 flights, "
                        "first in flight 0\n"
                        "m.mission: `require visit s within 1 h`: violated in 0 of 6 flights\n"))
      << flown.err;
  const Outcome again =
      run("$GLIDERCC campaign m.mission --flights 6 --fault none --boards 0 --resume c.csv");
  const auto violations = [](const Outcome& campaign) {
    const size_t from = campaign.out.find("m.mission: `require");
    return campaign.out.substr(from, campaign.out.rfind("\n6 flights") - from);
  };
  EXPECT_EQ(violations(again), violations(flown)) << again.err;
}

// accepts: GL5123 accepts: GL5122 accepts: GL9374
TEST_F(Sim, AFlightThatWentWellSaysNothing) {
  mission();
  const Outcome flown = run("$GLIDERCC sim m.mission -o f");
  EXPECT_EQ(flown.status, 0) << flown.err;
  EXPECT_EQ(flown.err, "");
  EXPECT_EQ(summary().at("wentWell"), true);
  EXPECT_EQ(summary().at("warnings"), nlohmann::json::array());
  EXPECT_EQ(summary().at("mission"), "m");
  EXPECT_GT(summary().at("figures").at("deepest"), 15);
  EXPECT_EQ(namesIn("f"), kFiles);
}

TEST_F(Sim, ARefusedCommandNamesTheLimitAndTheArgument) {
  mission("75 m");
  const Outcome flown = run("$GLIDERCC sim m.mission -o f");
  EXPECT_EQ(flown.status, 1);
  EXPECT_THAT(flown.err, HasSubstr("max_depth 60 m refuses a dive to 75 m"));
  EXPECT_THAT(flown.err, HasSubstr("[GL9371 command-refused]"));
  EXPECT_THAT(flown.err, HasSubstr("[GL9372 never-in-control]"));
  EXPECT_EQ(summary().at("wentWell"), false);
  EXPECT_THAT(summary().at("warnings").dump(), HasSubstr("GL9371"));
  EXPECT_THAT(slurp(folder_.path() / "f" / "report.html"), HasSubstr("refuses a dive to 75 m"));
}

TEST_F(Sim, AProgramThatAnswersButGetsNoControlIsStillAnSbc) {
  mission();
  // In scenario `layered` there is no hookbeh: nothing is refused, and no SBC gets control.
  const Outcome flown =
      run("$GLIDERCC build m.mission --target host -o program && "
          "$GLIDERCC sim --sbc ./program --scenario layered -o f");
  EXPECT_EQ(flown.status, 1) << flown.err;
  EXPECT_THAT(flown.err, HasSubstr("[GL9372 never-in-control]"));
  EXPECT_THAT(flown.err, Not(HasSubstr("never used this version")));
}

TEST_F(Sim, AnAbortIsReportedAtTheEnd) {
  mission();
  const Outcome flown =
      run("cp " GLIDER_SOURCE_DIR "/scenarios/skeleton.mi . && cp " GLIDER_SOURCE_DIR
          "/scenarios/default.toml failing.toml && printf '\n[[faults.abort]]\nat_s = 100\n' >> "
          "failing.toml && $GLIDERCC sim m.mission --scenario failing.toml -o f");
  EXPECT_EQ(flown.status, 1);
  EXPECT_THAT(flown.err, HasSubstr("[GL9370 flight-aborted]"));
  EXPECT_THAT(summary().at("warnings").dump(), HasSubstr("GL9370"));
}

/// The mission computes the salinity of the scenario's water from the CTD's readings.
TEST_F(Sim, TheMissionMeasuresTheSalinityOfTheScenario) {
  mission("20 m", "temp, cond, scipressure");
  std::string text = slurp(folder_.path() / "m.mission");
  const std::string when = "case missiontime >= 5 min exit";
  text.replace(text.find(when), when.size(),
               "case missiontime >= 5 min do log \"salt\", salinity end exit");
  (void)folder_.write("m.mission", text);
  (void)folder_.write("salt.toml",
                      "name = \"salt\"\nskeleton = \"skeleton.mi\"\n"
                      "duration_s = 3600\n[start]\nlatitude_deg = 39.175\n"
                      "longitude_deg = -73.835\n[ocean]\nsurface_salinity = 35.5\n"
                      "bottom_salinity = 35.5\n");
  const Outcome flown = run("$GLIDERCC sim m.mission --scenario salt.toml -o f");
  EXPECT_EQ(flown.status, 0) << flown.err;
  EXPECT_THAT(flown.out, testing::ContainsRegex(" salt 35\\.(49|50)[0-9]?\n"));
  EXPECT_THAT(slurp(folder_.path() / "f" / "trace.csv"), HasSubstr(",sci_water_cond (S/m)"));
}

TEST_F(Sim, LoggedValuesAreRoundedForPeopleOnly) {
  const Outcome flown = run("$GLIDERCC sim " GLIDER_SOURCE_DIR
                            "/missions/gallery/low_battery.mission --scenario low_battery -o f");
  EXPECT_EQ(flown.status, 0) << flown.err;
  EXPECT_THAT(flown.out, testing::ContainsRegex(" battery low 1[01]\\.[0-9]{1,3} V\n"));
  EXPECT_THAT(slurp(folder_.path() / "f" / "events.csv"),
              testing::ContainsRegex("\"battery low 1[01]\\.[0-9]{8,} V\""));
}

/// Also where the state lists it nowhere else, so that the trace has no column of it.
TEST_F(Sim, ALoggedTimeOfTheCalendarIsADate) {
  (void)folder_.write("d.mission",
                      "mission dated\nstate s\nbegin\n  flightprofile surfaced\n"
                      "  sensors       missiontime\n  entry do log \"begins\", utc end\n"
                      "  events\n    case missiontime > 2 min exit\nend\n");
  const Outcome flown = run("$GLIDERCC sim d.mission -o f");
  EXPECT_EQ(flown.status, 0) << flown.err;
  EXPECT_THAT(flown.out, testing::ContainsRegex(" begins 2009-08-11T14:13:[0-9]{2}Z\n"));
}

TEST_F(Sim, ASensorThatTheVehicleDoesNotCarry) {
  mission("20 m", "sci_oxy4_oxygen");
  const Outcome without = run("$GLIDERCC sim m.mission -o f");
  EXPECT_EQ(without.status, 1);
  EXPECT_THAT(without.err, HasSubstr("scenario `default` does not carry `sci_oxy4_oxygen`"));
  EXPECT_THAT(without.err, HasSubstr("[GL5123 sensor-not-carried]"));
  EXPECT_THAT(without.err, HasSubstr("hint: fly in scenario `bloom`, whose vehicle carries it, or "
                                     "set `surface_oxygen_uM` and `bottom_oxygen_uM` in [ocean]"));
  const Outcome with = run("$GLIDERCC sim m.mission --scenario bloom -o f");
  EXPECT_EQ(with.status, 0) << with.err;
}

TEST_F(Sim, ASensorOfTheUsersOwnPlatformFileIsUnknownAndSaidToBe) {
  // A share directory of our own, with one sensor more in the vehicle's platform file.
  const Outcome made =
      run("cp -rL $(dirname $GLIDERCC)/../share/glidercc share && chmod -R u+w share && "
          "printf '\\n[[sensor]]\\nname = \"sci_nitrate\"\\nunit = \"1\"\\nlowest = 0\\n"
          "highest = 100\\nbytes = 4\\nstale_after_s = 20\\nwhat = \"nitrate\"\\ncomputer = "
          "\"science\"\\n' >> "
          "share/platforms/slocum.toml && "
          "cp share/platforms/slocum.toml share/platforms/mine.toml && "
          "sed -i 's/^name = \"slocum\"/name = \"mine\"/' share/platforms/mine.toml");
  ASSERT_EQ(made.status, 0) << made.err;
  for (const char* head : {"", "platform mine\n"}) {
    mission("20 m", "depth", head);
    const Outcome beside = run("GLIDERCC_SHARE=share $GLIDERCC sim m.mission -o f");
    EXPECT_EQ(beside.status, 0) << "the mission does not read it" << beside.err;
    mission("20 m", "sci_nitrate", head);
    const Outcome read = run("GLIDERCC_SHARE=share $GLIDERCC sim m.mission -o f");
    EXPECT_EQ(read.status, 1) << read.out << read.err;
    EXPECT_THAT(read.err, HasSubstr("does not provide the sensor `sci_nitrate`"));
    EXPECT_THAT(read.err, HasSubstr("[GL5122 sensor-not-simulated]"));
    EXPECT_THAT(read.out, Not(HasSubstr("damaged")));
  }
}

TEST_F(Sim, ASecondFlightLeavesNothingOfTheFirst) {
  mission();
  ASSERT_EQ(run("$GLIDERCC sim m.mission --board host -o f --picture f/flight.svg").status, 0);
  EXPECT_TRUE(namesIn("f").contains("mission.log"));
  EXPECT_TRUE(namesIn("f").contains("flight.svg"));
  const std::string first = slurp(folder_.path() / "f" / "trace.csv");
  ASSERT_EQ(run("$GLIDERCC sim m.mission -o f --seed 7").status, 0);
  EXPECT_EQ(namesIn("f"), kFiles);
  EXPECT_NE(slurp(folder_.path() / "f" / "trace.csv"), first);
  EXPECT_EQ(namesIn("."), (std::set<std::string>{"f", "m.mission"})) << "nothing beside it";
}

TEST_F(Sim, WritesFlightsForOtherPrograms) {
  mission();
  const Outcome outcome =
      run("$GLIDERCC sim m.mission -o f --kml f/m.kml --geojson m.geojson --netcdf f/m.nc");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_TRUE(namesIn("f").contains("m.kml"));
  EXPECT_TRUE(namesIn("f").contains("m.nc"));
  EXPECT_THAT(slurp(folder_.path() / "f" / "m.kml"), HasSubstr("<name>true track</name>"));
  EXPECT_THAT(slurp(folder_.path() / "m.geojson"), HasSubstr("\"type\":\"FeatureCollection\""));
  EXPECT_THAT(slurp(folder_.path() / "f" / "m.nc").substr(0, 8), HasSubstr("HDF"));
  const Outcome lost = run("$GLIDERCC sim m.mission -o f --netcdf /nonexistent/m.nc");
  EXPECT_EQ(lost.status, 2);
  EXPECT_THAT(lost.err, HasSubstr("GL9002"));
}

TEST_F(Sim, AFolderWithOtherFilesIsNotTouched) {
  mission();
  ASSERT_EQ(run("mkdir f && echo mine > f/notes.txt").status, 0);
  const Outcome refused = run("$GLIDERCC sim m.mission -o f");
  EXPECT_EQ(refused.status, 2);
  EXPECT_THAT(refused.err, HasSubstr("cannot write the flight to `f`: it contains `notes.txt`"));
  EXPECT_THAT(refused.err, HasSubstr("[GL9374 output-folder-in-use]"));
  EXPECT_EQ(namesIn("f"), std::set<std::string>{"notes.txt"});
  // The same once a flight is there.
  ASSERT_EQ(run("rm f/notes.txt && $GLIDERCC sim m.mission -o f && echo mine > f/notes.txt").status,
            0);
  EXPECT_EQ(run("$GLIDERCC sim m.mission -o f").status, 2);
  EXPECT_TRUE(namesIn("f").contains("notes.txt"));
  EXPECT_EQ(run("$GLIDERCC sim m.mission -o m.mission").status, 2) << "a file is not a folder";
  EXPECT_EQ(run("mkdir here && cd here && $GLIDERCC sim ../m.mission -o .").status, 0);
  EXPECT_EQ(run("cd here && $GLIDERCC sim ../m.mission -o .").status, 2) << "it would be gone";
  EXPECT_EQ(namesIn("here"), kFiles);
}

TEST_F(Sim, WhatFailsOrIsKilledLeavesTheFormerFlight) {
  mission();
  ASSERT_EQ(run("$GLIDERCC sim m.mission -o f").status, 0);
  const std::string first = slurp(folder_.path() / "f" / "trace.csv");
  EXPECT_EQ(run("$GLIDERCC sim m.mission -o f --seed 7 --picture /nonexistent/p.svg").status, 2);
  EXPECT_EQ(run("$GLIDERCC sim m.mission -o f --set w.latitude=39.2").status, 2);
  // Killed while it writes: the file size limit ends the process.
  EXPECT_GT(run("ulimit -f 8; $GLIDERCC sim m.mission -o f --seed 7").status, 1);
  EXPECT_EQ(slurp(folder_.path() / "f" / "trace.csv"), first);
  EXPECT_EQ(namesIn("f"), kFiles);
  // What a killed process left is taken away by the next flight.
  ASSERT_EQ(run("$GLIDERCC sim m.mission -o f").status, 0);
  EXPECT_EQ(namesIn("."), (std::set<std::string>{"f", "m.mission"}));
}

TEST_F(Sim, PositionsAtLaunchAreReadAsTheLanguageDoes) {
  mission();
  const Outcome listed =
      run("$GLIDERCC params m.mission --set w.latitude=3910.5 --set 'w.longitude = -7349.8'");
  EXPECT_EQ(listed.status, 0) << listed.err;
  EXPECT_THAT(listed.out, HasSubstr("w     position  39 10.500 N 73 49.800 W"));
  EXPECT_EQ(listed.out.find("set to"), std::string::npos) << listed.out;
  // What is printed is read.
  (void)folder_.write("p.txt", "w.latitude = 39.25 S # south\nw.longitude = 12010.5\n");
  const Outcome filed = run("$GLIDERCC params m.mission --parameters p.txt");
  EXPECT_EQ(filed.status, 0) << filed.err;
  EXPECT_THAT(filed.out, HasSubstr("39 15.000 S 120 10.500 E"));
  for (const char* wrong : {"w.latitude=39.175", "w.latitude=9100", "w.latitude=3960",
                            "w.latitude=91 N", "w.latitude=73.83 W", "w.longitude=-73.8 W",
                            "w.latitude=-12210.5", "w.latitude=39,175 N"}) {
    const Outcome refused = run(std::string("$GLIDERCC params m.mission --set '") + wrong + "'");
    EXPECT_EQ(refused.status, 2) << wrong;
    EXPECT_THAT(refused.err, HasSubstr("[GL9052 bad-parameter]")) << wrong;
  }
  const Outcome swapped =
      run("$GLIDERCC params m.mission --set w.latitude=-7349.8 --set w.longitude=3910.5");
  EXPECT_EQ(swapped.status, 2);
  EXPECT_THAT(swapped.err, HasSubstr("the latitude comes first"));
}

TEST_F(Sim, APositionIsSetAsAWhole) {
  mission();
  (void)folder_.write("p.txt", "w = 39 15 S 120 10.5 E # south\n");
  const Outcome filed = run("$GLIDERCC params m.mission --parameters p.txt");
  EXPECT_EQ(filed.status, 0) << filed.err;
  EXPECT_THAT(filed.out, HasSubstr("39 15.000 S 120 10.500 E"));
  const Outcome half = run("$GLIDERCC params m.mission --parameters p.txt --set w.longitude=5.5E");
  EXPECT_THAT(half.out, HasSubstr("39 15.000 S 5 30.000 E"));
  // What the halves were before does not matter.
  (void)folder_.write("halves.txt", "w.latitude = 7349.8\nw.longitude = 3910.5\n");
  const Outcome whole =
      run("$GLIDERCC params m.mission --parameters halves.txt --set 'w=80.1 N 12.5 E'");
  EXPECT_EQ(whole.status, 0) << whole.err;
  EXPECT_THAT(whole.out, HasSubstr("80 06.000 N 12 30.000 E"));
  const Outcome refused = run("$GLIDERCC params m.mission --set 'w=73.83 W 39.175 N'");
  EXPECT_EQ(refused.status, 2);
  EXPECT_THAT(refused.err, HasSubstr("`w` cannot be `73.83 W 39.175 N`: the latitude comes first"));
}

TEST_F(Sim, NoOutputOverwritesAnInputOrAnother) {
  const std::string text = slurp(std::string(GLIDER_SOURCE_DIR) + "/missions/figure2.mission");
  (void)folder_.write("p.mission", text);
  for (const char* option : {"--kml", "--geojson", "--netcdf", "--picture"}) {
    const Outcome refused = run(std::string("$GLIDERCC sim p.mission ") + option + " ./p.mission");
    EXPECT_EQ(refused.status, 2) << option;
    EXPECT_THAT(refused.err, HasSubstr("[GL9350 output-is-input]")) << option;
    EXPECT_EQ(slurp(folder_.path() / "p.mission"), text) << option;
  }
  const Outcome twice = run("$GLIDERCC sim p.mission --kml o.x --geojson ./o.x");
  EXPECT_EQ(twice.status, 2);
  EXPECT_THAT(twice.err, HasSubstr("two outputs have this name"));
}

/// Such a path has no real name to compare with those of other outputs.
TEST_F(Sim, AnOutputBehindALoopOfLinksCannotBeWritten) {
  mission();
  std::filesystem::create_symlink("loop", folder_.path() / "loop");
  for (const char* output : {"loop/o.kml", "loop"}) {
    const Outcome outcome = run(std::string("$GLIDERCC sim m.mission --kml ") + output);
    EXPECT_EQ(outcome.status, 2) << output;
    EXPECT_THAT(outcome.err, HasSubstr("[GL9002 cannot-write]")) << output;
    EXPECT_THAT(outcome.err, HasSubstr("Too many levels of symbolic links")) << output;
    EXPECT_THAT(outcome.err, Not(HasSubstr("internal error"))) << output;
  }
}

/// A mission that the scenario's mission file of the vehicle refuses, and the pilot's own allows.
class SimWithOwnFile : public testing::Test {
 protected:
  SimWithOwnFile() {
    mission("deep", "65 m", "30 min");
    (void)folder_.write("ours.mi", R"(behavior: abend
    b_arg: overdepth(m)     75
    b_arg: overtime(s)    3600
behavior: surface
    b_arg: start_when(enum)  1
    b_arg: end_action(enum)  2
    b_arg: gps_wait_time(s)  0
behavior: hookbeh
    b_arg: max_depth(m)     72
)");
  }
  /// Writes `name`.mission, which dives to `bottom` again and again for the time `until`.
  void mission(const std::string& name, const std::string& bottom, const std::string& until) const {
    (void)folder_.write(name + ".mission", "mission " + name + R"(
state fly
begin
  flightprofile yo(5 m, )" + bottom + R"(, 26 deg, 26 deg)
  sensors       missiontime, depth
  events
    case missiontime > )" + until + R"( exit
end
)");
  }
  [[nodiscard]] Outcome sim(const std::string& options) const {
    return runShell("cd " + folder_.path().string() + " && $GLIDERCC sim " + options);
  }
  const TemporaryFolder folder_;
};

TEST_F(SimWithOwnFile, FliesWithItsLimits) {
  const Outcome bundled = sim("deep.mission");
  EXPECT_EQ(bundled.status, 1);
  EXPECT_THAT(bundled.err, testing::HasSubstr("`--mi FILE.mi` flies with yours"));
  const Outcome own = sim("deep.mission --mi ours.mi");
  EXPECT_EQ(own.status, 0) << own.err;
  EXPECT_EQ(own.err, "");
  EXPECT_THAT(own.out, testing::HasSubstr("fly → end (exit)"));
}

/// Its overtime is not raised for --duration, as that of a bundled file is.
TEST_F(SimWithOwnFile, ItsOvertimeIsTheVehicles) {
  mission("long", "20 m", "9 h");
  const Outcome own = sim("long.mission --mi ours.mi --duration 10h");
  EXPECT_THAT(own.err, testing::Not(testing::HasSubstr("overtime of the bundled")));
  EXPECT_THAT(own.out, testing::HasSubstr("OVERTIME"));
}

TEST_F(SimWithOwnFile, IsRefusedWhereItCannotBeUsed) {
  EXPECT_EQ(sim("ours.mi --mi ours.mi").status, 2);
  EXPECT_EQ(sim("deep.mission --mi none.mi").status, 2);
  (void)folder_.write("without.mi", "behavior: surface\n    b_arg: start_when(enum) 1\n");
  const Outcome without = sim("deep.mission --mi without.mi -o without");
  EXPECT_EQ(without.status, 2) << without.out;
  EXPECT_THAT(without.err, testing::HasSubstr("the mission `without.mi` has errors: it has no "
                                              "behavior `hookbeh` [GL5120 skeleton-errors]"));
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "without"));
  EXPECT_EQ(sim("without.mi -o alone").status, 0) << "a mission of the vehicle's own needs none";
  (void)folder_.write("broken.mi", "behavior: hookbeh\n    b_arg: max_depth(m) deep\n");
  const Outcome broken = sim("deep.mission --mi broken.mi");
  EXPECT_EQ(broken.status, 2);
  const std::string_view err = broken.err;
  EXPECT_EQ(err.find("broken.mi:2"), err.rfind("broken.mi:2")) << "once: " << err;
  EXPECT_EQ(sim("deep.mission --mi ours.mi --picture ours.mi").status, 2);
}

}  // namespace
}  // namespace glider::tests
