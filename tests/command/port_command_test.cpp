// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// From a mission to a folder for a vehicle without the hooks, and a flight from that folder.

#include "tests/support/command.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <string>

namespace glider::tests {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class PortCommand : public testing::Test {
 protected:
  PortCommand() {
    fs::copy_file(GLIDER_SOURCE_DIR "/missions/figure2.mission", path() / "figure2.mission");
  }
  [[nodiscard]] const fs::path& path() const { return folder_.path(); }
  [[nodiscard]] Outcome run(const std::string& command) const {
    return runShell("cd " + path().string() + " && $GLIDERCC " + command);
  }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(path() / name) << text;
  }
  [[nodiscard]] std::string read(const std::string& name) const { return slurp(path() / name); }

 private:
  TemporaryFolder folder_;
};

TEST_F(PortCommand, AFolderIsBuiltAndFlownFromItAlone) {
  const Outcome built = run("build figure2.mission --dialect extctl -o port");
  EXPECT_EQ(built.status, 0) << built.err;
  EXPECT_EQ(built.err, "");
  for (const char* name :
       {"README.md", "port.toml", "figure2.mission", "sbc/figure2", "vehicle/config/extctl.ini",
        "vehicle/config/proglets.txt", "vehicle/missions/samplemi.mi"}) {
    EXPECT_TRUE(fs::exists(path() / "port" / name)) << name;
  }
  fs::remove(path() / "figure2.mission");
  const Outcome here = run("sim port -o here");
  EXPECT_EQ(here.status, 0) << here.err;
  EXPECT_THAT(here.out, HasSubstr("s2 → s1 (return)"));
  EXPECT_THAT(here.out, HasSubstr("start_when 11: the science computer asks for it"));
  const Outcome board = run("sim port -o board --board host");
  EXPECT_EQ(board.status, 0) << board.err;
  EXPECT_EQ(read("here/trace.csv"), read("board/trace.csv"))
      << "a program behind a terminal flies as in process";
}

/// It reports only when it changes, and a dive takes longer than the reading's stale_after.
TEST_F(PortCommand, WhetherItDivesStaysKnownOverALeg) {
  write("legs.mission", R"(mission legs
state look
begin
  flightroute   heading(90 deg)
  flightprofile yo_times(top = 4 m, bottom = 30 m, times = 3)
  sensors       missiontime, depth, temp, m_depth_state
  events
    case profiledone                                    exit
    case turned && climbing                             do log "warmest of the dive", highest(temp, this dive) end stay
    case climbing && held(temp > 18 degC, 20 s)         do log "warm on the climb" end stay
    case missiontime > 1 h                              exit
end
)");
  EXPECT_EQ(run("build legs.mission --dialect extctl --target host -o port").status, 0);
  const auto count = [](const std::string& text, const std::string& what) {
    size_t found = 0;
    for (size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) {
      ++found;
    }
    return found;
  };
  for (const char* what : {"legs.mission", "port"}) {
    const Outcome flown = run(std::string("sim ") + what + " --scenario bloom -o f");
    EXPECT_EQ(flown.status, 0) << flown.err;
    const std::string events = read("f/events.csv");
    EXPECT_EQ(count(events, "warmest of the dive 2"), 3U) << what << events;
    EXPECT_GE(count(events, "warm on the climb"), 3U) << what;
    EXPECT_THAT(events, HasSubstr("\"profiledone\"")) << what;
  }
}

/// The vehicle itself never ends its mission: at the surface it waits for an operator. Hours of
/// that are not part of the flight.
TEST_F(PortCommand, AFlightEndsWhereTheVehicleWaitsForAnOperator) {
  write("short.mission",
        "mission short\n\nstate s\nbegin\n  flightroute noheading\n"
        "  flightprofile yo(4 m, 20 m, 26 deg, 26 deg)\n"
        "  sensors missiontime\n  events\n    case missiontime > 20 min exit\nend\n");
  for (const char* release : {"science", "mission-mode"}) {
    const std::string name = std::string("port-") + release;
    ASSERT_EQ(run("build short.mission --dialect extctl" +
                  std::string(release == std::string("science") ? "" : " --release mission-mode") +
                  " -o " + name)
                  .status,
              0);
    const Outcome flown = run("sim " + name + " --duration 5h -o flight-" + release);
    EXPECT_THAT(flown.out, HasSubstr("the vehicle waits for an operator")) << release;
    EXPECT_THAT(flown.out, Not(HasSubstr("simulated time of"))) << release;
  }
}

TEST_F(PortCommand, TheReleaseDecidesWhatStartsBehaviours) {
  EXPECT_EQ(run("build figure2.mission --dialect extctl --release mission-mode -o port").status, 0);
  const std::string mission = read("port/vehicle/missions/samplemi.mi");
  EXPECT_THAT(mission, HasSubstr("behavior: goto_wpt"));
  EXPECT_THAT(mission, HasSubstr("u_mission_mode"));
  const Outcome flown = run("sim port -o flight");
  EXPECT_EQ(flown.status, 0) << flown.err;
  EXPECT_THAT(flown.out, HasSubstr("start_when 15: u_mission_mode has a bit of 1"));
}

TEST_F(PortCommand, TheBoundOfThePageIsThatOfTheOptions) {
  EXPECT_EQ(
      run("build figure2.mission --dialect extctl --surface-after 90min --max-depth 40 -o port")
          .status,
      0);
  const std::string page = read("port/README.md");
  EXPECT_THAT(page, HasSubstr("after 90 min without contact"));
  EXPECT_THAT(page, HasSubstr("1 h 53 min 20 s after its last contact"));
  EXPECT_THAT(page, HasSubstr("climb from 63 m 1260 s"));
  EXPECT_THAT(read("port/vehicle/missions/samplemi.mi"), HasSubstr("when_secs(s) 5400"));
}

// accepts: GL3124
TEST_F(PortCommand, ADepthThatTheProgramWouldRefuseIsAnError) {
  const Outcome built = run("build figure2.mission --dialect extctl --max-depth 10m -o port");
  EXPECT_EQ(built.status, 1);
  EXPECT_THAT(built.err, AllOf(HasSubstr("but its program refuses more than 10 m"),
                               HasSubstr("change `--max-depth`")));
  EXPECT_FALSE(fs::exists(path() / "port"));
  EXPECT_EQ(run("build figure2.mission --dialect extctl --max-depth 3000m -o port").status, 2);
}

// accepts: GL3127 GL4016
TEST_F(PortCommand, TheFolderIsCheckedTogether) {
  ASSERT_EQ(run("build figure2.mission --dialect extctl -o port").status, 0);
  const Outcome fine = run("check port --report");
  EXPECT_EQ(fine.status, 0) << fine.err;
  EXPECT_THAT(fine.out,
              AllOf(HasSubstr("by behaviour 2 `surface` (start_when 12, when_secs 14400)"),
                    HasSubstr("without hookbeh nothing on the vehicle watches the SBC")));
  std::string mission = read("port/vehicle/missions/samplemi.mi");
  const auto timer = mission.find("start_when(enum) 12");
  ASSERT_NE(timer, std::string::npos);
  write("port/vehicle/missions/samplemi.mi", mission.replace(timer, 19, "start_when(enum) 5"));
  const Outcome unsafe = run("check port");
  EXPECT_EQ(unsafe.status, 1);
  EXPECT_THAT(unsafe.err, AllOf(HasSubstr("GL3127"), HasSubstr("silence of the SBC")));
  write("port/figure2.mission", slurp(path() / "figure2.mission") + "\n# another text\n");
  EXPECT_NE(run("check port").status, 2) << "a comment changes no program";
  const auto number = mission.find("u_mission_param_l(nodim) ");
  ASSERT_NE(number, std::string::npos);
  write("port/vehicle/missions/samplemi.mi", mission.insert(number + 25, "1"));
  const Outcome other = run("check port");
  EXPECT_EQ(other.status, 2);
  EXPECT_THAT(other.err, HasSubstr("GL4016"));
}

// accepts: GL3125 GL3133 GL4016
TEST_F(PortCommand, AChangedLineOfTheMissionFileIsReported) {
  ASSERT_EQ(run("build figure2.mission --dialect extctl -o port").status, 0);
  const std::string mission = read("port/vehicle/missions/samplemi.mi");
  const struct {
    const char* line;
    const char* by;
    const char* reported;
  } rows[] = {
      {"c_extctl_on(s) 1", "c_extctl_on(s) -1", "c_extctl_on is -1, not 1"},
      {"when_secs(s) 14400", "when_secs(s) 0", "no contact for 0 s (when_secs)"},
      {"when_secs(s) 14400", "when_secs(s) -1", "no contact for -1 s (when_secs)"},
      {"end_action(enum) 1", "end_action(enum) 0", "end_action 0"},
      {"d_target_altitude(m) 5", "d_target_altitude(m) -1", "d_target_altitude -1"},
      {"overdepth(m) ", "overdepth(m) 0 # ", "GL3125"},
      {"d_target_depth(m) 1000003", "d_target_depth(m) 30", "no `yo` with the d_target_depth"},
      {"u_mission_param_l(nodim) ", "u_mission_param_l(nodim) 7", "GL4016"},
  };
  for (const auto& [line, by, reported] : rows) {
    std::string twin = mission;
    const auto at = twin.find(line);
    ASSERT_NE(at, std::string::npos) << line;
    write("port/vehicle/missions/samplemi.mi", twin.replace(at, std::string(line).size(), by));
    const Outcome checked = run("check port");
    EXPECT_NE(checked.status, 0) << by;
    EXPECT_THAT(checked.err, HasSubstr(reported)) << by;
  }
  // The vehicle takes the last line.
  write("port/vehicle/missions/samplemi.mi", mission + "sensor: u_mission_param_l(nodim) 7\n");
  EXPECT_THAT(run("check port").err, HasSubstr("GL4016"));
}

TEST_F(PortCommand, ACampaignFliesTheFolder) {
  ASSERT_EQ(run("build figure2.mission --dialect extctl --surface-after 1h -o port").status, 0);
  const Outcome flown = run("campaign port --flights 38 --csv flights.csv");
  EXPECT_EQ(flown.status, 0) << flown.out << flown.err;
  for (const char* kind : {"none ", "bit flips ", "SBC power cut ", "damaged checkpoints ",
                           "science reboot ", "console on science ", "shallow water "}) {
    EXPECT_THAT(flown.out, HasSubstr(kind));
  }
  EXPECT_THAT(flown.out, testing::Not(HasSubstr("sensor frozen"))) << "nothing notices it";
  EXPECT_EQ(std::ranges::count(read("flights.csv"), '\n'), 38 + 2);
  const Outcome resumed = run("campaign port --flights 38 --resume flights.csv");
  EXPECT_EQ(resumed.status, 0) << resumed.err;
  EXPECT_EQ(run("campaign port --flights 2 --fault 'sensor frozen'").status, 2);
  EXPECT_EQ(run("campaign port --only 1 -o flight").status, 0);
  EXPECT_TRUE(fs::exists(path() / "flight/report.html"));
}

/// A campaign that sees nothing would be worse than none.
TEST_F(PortCommand, ACampaignSeesWhatAMissionFileDoesWrong) {
  ASSERT_EQ(run("build figure2.mission --dialect extctl --surface-after 1h -o port").status, 0);
  const std::string mission = read("port/vehicle/missions/samplemi.mi");
  const struct {
    const char* line;
    const char* by;
    const char* options;
    const char* seen;
  } rows[] = {
      {"overdepth(m) ", "overdepth(m) 8 # ", "--fault none", "m deep, at most"},
      {"overtime(s) -1", "overtime(s) 600", "--fault none", "aborted its mission"},
      {"d_target_altitude(m) 5", "d_target_altitude(m) -1", "--fault 'shallow water'",
       "on the bottom at"},
      {"start_when(enum) 12", "start_when(enum) 5", "--fault 'SBC power cut'", "under water for"},
      {"when_secs(s) 3600", "when_secs(s) 1e9", "--fault 'SBC power cut'", "under water for"},
      // A line that says nothing wrong excuses nothing.
      {"overtime(s) -1", "overtime(s) 600", "--fault 'line cut'", "aborted its mission"},
      {"overtime(s) -1", "overtime(s) 600", "--fault delay", "aborted its mission"},
  };
  for (const auto& [line, by, options, seen] : rows) {
    std::string twin = mission;
    const auto at = twin.find(line);
    ASSERT_NE(at, std::string::npos) << line;
    write("port/vehicle/missions/samplemi.mi", twin.replace(at, std::string(line).size(), by));
    const Outcome flown = run(std::string("campaign port --flights 24 ") + options);
    EXPECT_EQ(flown.status, 1) << by << flown.out << flown.err;
    EXPECT_THAT(flown.out, HasSubstr(seen)) << by;
  }
  // A file that allows more than the program was built for: the flight keeps to the latter.
  std::string deep = mission;
  const auto abend = deep.find("overdepth(m) 30");
  deep.replace(abend, 15, "overdepth(m) 120");
  deep.insert(deep.find("# Between the two depths"),
              "behavior: yo\n    b_arg: start_when(enum) 0\n"
              "    b_arg: num_half_cycles_to_do(nodim) -1\n    b_arg: d_target_depth(m) 60\n"
              "    b_arg: d_use_pitch(enum) 3\n    b_arg: d_pitch_value(X) -0.45\n"
              "    b_arg: c_target_depth(m) 5\n\n");
  write("port/vehicle/missions/samplemi.mi", deep);
  for (const char* fault : {"none", "'bit flips'", "'line cut'"}) {
    const Outcome flown = run(std::string("campaign port --flights 4 --fault ") + fault);
    EXPECT_EQ(flown.status, 1) << fault << flown.out << flown.err;
    EXPECT_THAT(flown.out, HasSubstr("m deep, at most")) << fault;
  }
  // Without a limit of depth, the time up is that from the hull's.
  std::string twin = mission;
  const auto limit = twin.find("    b_arg: overdepth(m) ");
  twin.erase(limit, twin.find('\n', limit) + 1 - limit);
  const auto timer = twin.find("start_when(enum) 12");
  write("port/vehicle/missions/samplemi.mi", twin.replace(timer, 19, "start_when(enum) 5"));
  EXPECT_THAT(run("campaign port --flights 24 --fault 'SBC power cut'").out,
              HasSubstr("under water for"));
}

/// What a mission imports is in its folder too, where it finds it again.
TEST_F(PortCommand, AFolderHasWhatTheMissionImports) {
  fs::create_directories(path() / "m/lib");
  fs::create_directories(path() / "common");
  write("m/lib/shallow.mission", "import \"../../common/deep\"\n\nconst shallow: length = 5 m\n");
  write("common/deep.mission", "const deep: length = 25 m\n");
  write("m/flies.mission",
        "mission flies\n\nimport \"lib/shallow\"\nimport \"../common/deep\"\n\nstate s\nbegin\n"
        "  flightroute   heading(90 deg)\n  flightprofile yo(shallow, deep)\n"
        "  sensors missiontime\n  events\n    case missiontime > 1 h exit\nend\n");
  ASSERT_EQ(run("build m/flies.mission --dialect extctl -o port").status, 0);
  for (const char* name :
       {"source/m/flies.mission", "source/m/lib/shallow.mission", "source/common/deep.mission"}) {
    EXPECT_TRUE(fs::exists(path() / "port" / name)) << name;
  }
  fs::remove_all(path() / "m");
  fs::remove_all(path() / "common");
  fs::rename(path() / "port", path() / "elsewhere");
  EXPECT_EQ(run("check elsewhere").status, 0);
  EXPECT_EQ(run("params elsewhere").out, "mission flies has no parameters\n");
  const Outcome flown = run("sim elsewhere -o f");
  EXPECT_EQ(flown.status, 0) << flown.err;
  EXPECT_THAT(flown.out, HasSubstr("s → end (exit)"));
}

/// `--max-depth` cannot raise what the vehicle can do.
TEST_F(PortCommand, ADepthBeyondTheVehicleNamesItsPlatform) {
  write("deep.mission",
        "mission deep\n\nstate s\nbegin\n  flightroute heading(90 deg)\n"
        "  flightprofile yo(5 m, 900 m)\n  sensors missiontime\n  events\n"
        "    case missiontime > 1 h exit\nend\n");
  for (const char* options : {"", " --max-depth 900m"}) {
    const Outcome built = run("build deep.mission --dialect extctl -o port" + std::string(options));
    EXPECT_EQ(built.status, 1);
    EXPECT_THAT(built.err, HasSubstr("or change the greatest depth of the platform `slocum`"));
  }
}

// accepts: GL5120
TEST_F(PortCommand, ItsMissionFileIsNotFlownWithTheHooks) {
  ASSERT_EQ(run("build figure2.mission --dialect extctl -o port").status, 0);
  for (const char* command : {"sim figure2.mission --mi port/vehicle/missions/samplemi.mi -o f",
                              "check figure2.mission --scenario default --mi "
                              "port/vehicle/missions/samplemi.mi"}) {
    const Outcome refused = run(command);
    EXPECT_EQ(refused.status, 2) << command;
    EXPECT_THAT(refused.err, HasSubstr("steered by its port, not by hookbeh")) << command;
  }
}

// accepts: GL4015
TEST_F(PortCommand, WhatThePortCannotCommandIsAnErrorWithTheNearest) {
  write("hover.mission",
        "mission hovers\n\nstate s\nbegin\n  flightprofile dive_and_hold(20 m, 26 deg, 10 "
        "min)\n"
        "  sensors missiontime\n  events\n    case missiontime > 1 h exit\nend\n");
  const Outcome built = run("build hover.mission --dialect extctl -o port");
  EXPECT_EQ(built.status, 1);
  EXPECT_THAT(built.err, HasSubstr("GL4015"));
  EXPECT_THAT(built.err, HasSubstr("begin entry do descend(at, usual_pitch) end end"));
  EXPECT_THAT(built.err, HasSubstr("hover.mission:5:17: error: "))
      << "the pilot's line, not the library's";
  EXPECT_THAT(built.err, HasSubstr("note: it is commanded here"));
  EXPECT_FALSE(fs::exists(path() / "port")) << "nothing is written";
}

TEST_F(PortCommand, AHeldFinIsOneOfThem) {
  write("spiral.mission",
        "mission spiral\n\nstate s\nbegin\n  flightroute fixed_fin(10 deg)\n"
        "  flightprofile yo(4 m, 20 m, 26 deg, 26 deg)\n"
        "  sensors missiontime\n  events\n    case missiontime > 1 h exit\nend\n");
  const Outcome built = run("build spiral.mission --dialect extctl -o port");
  EXPECT_EQ(built.status, 1);
  EXPECT_THAT(built.err, AllOf(HasSubstr("GL4015"), HasSubstr("`fin`"),
                               HasSubstr("spiral.mission:5:15: error: ")));
}

TEST_F(PortCommand, PumpAndBatteryAreOthers) {
  write("trim.mission",
        "mission trim\n\nstate s\nbegin\n  flightroute noheading\n"
        "  flightprofile fixed_trim(-50 cc, 2 mm)\n"
        "  sensors missiontime, depth\n  events\n    case depth > 9 m exit\n    case missiontime > "
        "1 h "
        "exit\nend\n");
  const Outcome built = run("build trim.mission --dialect extctl -o port");
  EXPECT_EQ(built.status, 1);
  EXPECT_THAT(built.err, AllOf(HasSubstr("GL4015"), HasSubstr("`pump`"), HasSubstr("`battery`")));
}

TEST_F(PortCommand, ANapIsAnother) {
  write("sleeps.mission",
        "mission sleeps\nnap at most 4 min\n\nstate s\nbegin\n"
        "  flightprofile yo(4 m, 20 m, 26 deg, 26 deg)\n"
        "  sensors missiontime\n  events\n    case missiontime > 1 h exit\nend\n");
  const Outcome built = run("build sleeps.mission --dialect extctl -o port");
  EXPECT_EQ(built.status, 1);
  EXPECT_THAT(built.err, AllOf(HasSubstr("GL4015"), HasSubstr("`nap`"),
                               HasSubstr("delete the line `nap at most`")));
}

// accepts: GL5131
TEST_F(PortCommand, MoreSensorsThanThePortHasAreAnError) {
  std::string text =
      "mission many\n\nstate s\nbegin\n  flightprofile yo(4 m, 20 m, 26 deg, 26 deg)\n  sensors "
      "missiontime";
  for (const char* sensor :
       {"m_pitch", "m_roll", "m_heading", "m_altitude", "m_battery", "m_vacuum", "m_speed",
        "m_water_depth", "m_gps_lat", "m_gps_lon", "m_depth_rate", "m_pressure", "m_fin",
        "m_battpos", "m_ballast_pumped", "m_leakdetect_voltage", "m_water_vx", "m_water_vy"}) {
    text += std::string(", ") + sensor;
  }
  write("many.mission", text + "\n  events\n    case missiontime > 1 h exit\nend\n");
  const Outcome refused = run("build many.mission --dialect extctl -o port");
  EXPECT_EQ(refused.status, 2) << refused.out;
  EXPECT_THAT(refused.err, HasSubstr("GL5131"));
  EXPECT_THAT(refused.err, HasSubstr("--port-sensors 64"));
  EXPECT_EQ(run("build many.mission --dialect extctl --port-sensors 64 -o port").status, 0);
}

// accepts: GL4016
TEST_F(PortCommand, FilesOfDifferentMissionsDoNotFly) {
  EXPECT_EQ(run("build figure2.mission --dialect extctl -o port").status, 0);
  const fs::path mission = path() / "port/figure2.mission";
  std::string text = slurp(mission);
  const size_t at = text.find("1500");
  ASSERT_NE(at, std::string::npos);
  std::ofstream(mission) << text.replace(at, 4, "1501");
  const Outcome flown = run("sim port -o flight");
  EXPECT_EQ(flown.status, 2);
  EXPECT_THAT(flown.err, HasSubstr("GL4016"));
}

// accepts: GL5130
// accepts: GL4016
TEST_F(PortCommand, AListOfOtherSensorsOrAnotherOrderIsRefused) {
  ASSERT_EQ(run("build figure2.mission --dialect extctl -o port").status, 0);
  const std::string list = read("port/vehicle/config/extctl.ini");
  const auto refused = [&](const std::string& twin) {
    ASSERT_NE(twin, list);
    write("port/vehicle/config/extctl.ini", twin);
    const Outcome checked = run("check port");
    EXPECT_EQ(checked.status, 2) << twin;
    EXPECT_THAT(checked.err, HasSubstr("lists other sensors, or another speed"));
  };
  std::string twin = list;
  const size_t d = twin.find("u_mission_param_d"), e = twin.find("u_mission_param_e");
  std::swap(twin.at(d + 16), twin.at(e + 16));
  refused(twin);
  const size_t line = list.find("u_mission_param_f");
  refused(list.substr(0, line) + list.substr(list.find('\n', line) + 1));
}

TEST_F(PortCommand, AListOfSensorsWithAnErrorIsNamed) {
  EXPECT_EQ(run("build figure2.mission --dialect extctl -o port").status, 0);
  std::ofstream(path() / "port/vehicle/config/extctl.ini") << "mp\nu_mission_param_a rad extra\n";
  const Outcome flown = run("sim port -o flight");
  EXPECT_EQ(flown.status, 2);
  EXPECT_THAT(flown.err, AllOf(HasSubstr("GL5130"),
                               HasSubstr("extctl.ini: line 2: expected a sensor and its unit")));
}

TEST_F(PortCommand, AFolderMustBeNamed) {
  const Outcome built = run("build figure2.mission --dialect extctl");
  EXPECT_EQ(built.status, 2);
  EXPECT_THAT(built.err, HasSubstr("-o FOLDER"));
}

}  // namespace
}  // namespace glider::tests
