// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// A flight is one of the vehicle that the mission names, whichever command flies it.

#include "tests/support/command.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace glider::tests {
namespace {

using testing::HasSubstr;
using testing::Not;

/// A share directory of our own, in which platform `mine` is `slocum` with a change.
class PlatformOfFlights : public ::testing::Test {
 protected:
  /// `change`: a line of sed.
  void platform(const std::string& change) const {
    const Outcome made = run(
        "rm -rf share && cp -rL $(dirname $GLIDERCC)/../share/glidercc share && chmod -R u+w share "
        "&& sed -e 's/^name = \"slocum\"/name = \"mine\"/' -e '" +
        change + "' share/platforms/slocum.toml > share/platforms/mine.toml");
    ASSERT_EQ(made.status, 0) << made.err;
  }
  void mission(const std::string& name, const std::string& head) const {
    (void)folder_.write(name, "mission m\n" + head +
                                  "state s\nbegin\n"
                                  "  flightprofile yo(5 m, 20 m, 26 deg, 26 deg)\n"
                                  "  sensors missiontime, depth\n"
                                  "  events\n    case missiontime >= 5 min exit\nend\n");
  }
  [[nodiscard]] Outcome run(const std::string& line) const {
    return runShell("cd " + folder_.path().string() + " && " + line);
  }
  [[nodiscard]] Outcome glidercc(const std::string& line) const {
    return run("GLIDERCC_SHARE=share $GLIDERCC " + line);
  }

  /// The greatest number in a column of a flight's trace.
  [[nodiscard]] double greatest(const std::string& flight, const std::string& column) const {
    const Outcome out = run("awk -F, -v 'name=" + column +
                            "' 'NR == 1 { for (i = 1; i <= NF; ++i) at[$i] = i; next } "
                            "$at[name] > most { most = $at[name] } END { print most + 0 }' " +
                            flight + "/trace.csv");
    return std::stod(out.out);
  }

  const TemporaryFolder folder_;
};

const std::string kCampaign = "campaign --boards 0 --flights 2 --csv f.csv ";

TEST_F(PlatformOfFlights, HookbehHasTheHullOfThisVehicle) {
  platform("s/^pump_cc = .*/pump_cc = 100/");
  mission("mine.mission", "platform mine\n");
  ASSERT_EQ(glidercc("sim -o f mine.mission").status, 0);
  EXPECT_EQ(greatest("f", "c_ballast_pumped (cc)"), 100);
  EXPECT_EQ(glidercc(kCampaign + "mine.mission").status, 0)
      << "the checks of the flight use the same number";
}

TEST_F(PlatformOfFlights, ACampaignFliesEachMissionsOwn) {
  platform("");
  mission("slocum.mission", "");
  mission("mine.mission", "platform mine\n");
  EXPECT_EQ(glidercc(kCampaign + "slocum.mission mine.mission").status, 0);
}

TEST_F(PlatformOfFlights, ACampaignFliesEachMissionInItsOwnVehicle) {
  platform("s/^reference_area_m2 = .*/reference_area_m2 = 0.4/");  // slow
  mission("slocum.mission", "");
  mission("mine.mission", "platform mine\n");
  /// The second flight's row, from its fault on; it is the second mission's.
  const auto second = [&](const std::string& first_mission, const std::string& second_mission) {
    const Outcome flown = glidercc(kCampaign + first_mission + " " + second_mission);
    EXPECT_EQ(flown.status, 0) << flown.err;
    return run("sed -n 4p f.csv | cut -d, -f3-").out;
  };
  const std::string slow = second("slocum.mission", "mine.mission");
  EXPECT_EQ(slow, second("mine.mission", "mine.mission"));
  EXPECT_NE(slow, second("mine.mission", "slocum.mission"));
}

/// A trace without the dead-reckoned position: the vehicle's software knows the hull of the
/// platform, not the one of a scenario.
std::string withoutReckoning(const std::string& csv) {
  std::string out;
  std::set<size_t> reckoned;
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream fields(line);
    size_t at = 0;
    for (std::string field; std::getline(fields, field, ','); ++at) {
      if (field.starts_with("m_lat") || field.starts_with("m_lon") || field.contains("_lmc")) {
        reckoned.insert(at);
      }
      out += reckoned.contains(at) ? "," : field + ",";
    }
    out += "\n";
  }
  return out;
}

TEST_F(PlatformOfFlights, DragAndBatteriesAreThePlatformsUnlessTheScenarioSaysOtherwise) {
  mission("mine.mission", "platform mine\n");
  const std::string slow = "s/^wing_lift = .*/wing_lift = 1.5/";
  const std::string hungry = "s/^W = 0.8$/W = 30.0/";
  const auto flight = [&](const std::string& change, const std::string& scenario) {
    platform(change);
    const Outcome flown = glidercc("sim -o f mine.mission --scenario " + scenario);
    EXPECT_EQ(flown.status, 0) << flown.err;
    return withoutReckoning(slurp(folder_.path() / "f" / "trace.csv"));
  };
  const std::string usual = flight("", "default");
  EXPECT_NE(flight(slow, "default"), usual);
  EXPECT_NE(flight(hungry, "default"), usual);
  const std::string given =
      "sed -e 's/^.vehicle.$/&\\nwing_lift = 3.7342698373/' -e '$a [vehicle.battery]\\nhotel_W = "
      "0.8' "
      "share/scenarios/default.toml > share/scenarios/given.toml";
  platform("");
  ASSERT_EQ(run(given).status, 0);
  for (const std::string& change : {slow, hungry}) {
    platform(change);
    ASSERT_EQ(run(given).status, 0);
    ASSERT_EQ(glidercc("sim -o f mine.mission --scenario given").status, 0);
    EXPECT_EQ(withoutReckoning(slurp(folder_.path() / "f" / "trace.csv")), usual) << change;
  }
}

/// The Slocum with its sensors in another order and two of its own, without those that a Slocum has
/// for itself: nothing but names may count.
std::string otherOrder(std::string text) {
  const std::string optode = "sensors = [\"sci_oxy4_oxygen\"]";
  text.replace(text.find(optode), optode.size(), "sensors = []");
  const size_t instrument = text.find("[[instrument]]\nname = \"optode\"");
  text.erase(instrument, text.find("\n\n", instrument) - instrument);
  std::vector<std::string> sensors;
  const std::string mark = "[[sensor]]";
  const size_t first = text.find("\n" + mark) + 1;
  for (size_t at = first, end = 0; at != std::string::npos; at = end) {
    end = text.find("\n" + mark, at);
    end = end == std::string::npos ? end : end + 1;
    sensors.push_back(text.substr(at, end - at) + "\n");
  }
  std::erase_if(sensors, [](const std::string& sensor) {
    return sensor.contains("\"m_battpos\"") || sensor.contains("\"m_vacuum\"") ||
           sensor.contains("\"sci_oxy4_oxygen\"");
  });
  std::ranges::reverse(sensors);
  text.resize(first);
  const std::string own = mark +
                          "\nname = \"m_thruster_rpm\"\nunit = \"1\"\nlowest = 0\nhighest = "
                          "3000\nbytes = 8\nstale_after_s = 20\nwhat = \"a thruster\"\n"
                          "computer = \"flight\"\n";
  text += own;
  for (const std::string& sensor : sensors) {
    text += sensor;
  }
  return text + own.substr(0, own.find("m_thruster")) + "sci_rpm" +
         own.substr(own.find("\"\nunit"));
}

TEST_F(PlatformOfFlights, AVehicleWithOtherSensorsFliesInProcessAndOnABoard) {
  platform("");
  const std::filesystem::path file = folder_.path() / "share/platforms/mine.toml";
  const std::string text = otherOrder(slurp(file));
  ASSERT_TRUE(text.contains("m_thruster_rpm") && !text.contains("m_battpos"));
  std::ofstream(file) << text;
  mission("slocum.mission", "");
  mission("mine.mission", "platform mine\n");
  for (const std::string board : {"", "--board ts5500 "}) {
    SCOPED_TRACE(board);
    const Outcome flown = glidercc("sim -o a " + board + "mine.mission");
    ASSERT_EQ(flown.status, 0) << flown.err;
    ASSERT_EQ(glidercc("sim -o b " + board + "slocum.mission").status, 0);
    EXPECT_EQ(slurp(folder_.path() / "a" / "trace.csv"), slurp(folder_.path() / "b" / "trace.csv"));
  }
  EXPECT_EQ(glidercc(kCampaign + "--fault none mine.mission").status, 0);
}

TEST_F(PlatformOfFlights, AMissionInCIsForTheVehicleThatItDefines) {
  platform("");
  const std::filesystem::path file = folder_.path() / "share/platforms/mine.toml";
  const std::string text = otherOrder(slurp(file));
  std::ofstream(file) << text;
  ASSERT_EQ(glidercc("platform mine --header > mine_sensors.h").status, 0);
  (void)folder_.write("dive.c",
                      "#define GLIDER_DEFINE_VEHICLE\n"
                      "#define GLIDER_SENSORS_HEADER \"mine_sensors.h\"\n"
                      "#include <runtime/c/glider.h>\n"
                      "int main(int argc, char** argv) {\n"
                      "  const double deep = 15;\n"
                      "  eventList list = newEventList();\n"
                      "  addEvent(list, EVENT(GEQ, M_DEPTH, &deep));\n"
                      "  if (gliderOpen(argc, argv, \"dive\")) return 2;\n"
                      "  dive();\n"
                      "  while (gliderRun(list)) releaseControl();\n"
                      "  return gliderExitStatus();\n}\n");
  const Outcome built =
      run("cc -I. -I$(dirname $GLIDERCC)/../share/glidercc/c dive.c -o dive "
          "$(GLIDERCC_SHARE=share $GLIDERCC targets --libs host)");
  ASSERT_EQ(built.status, 0) << built.err;
  const Outcome flown = glidercc("sim --platform mine --sbc ./dive -o f");
  EXPECT_EQ(flown.status, 0) << flown.out << flown.err;
  EXPECT_GT(greatest("f", "true_depth (m)"), 15);
  EXPECT_NE(glidercc("sim --sbc ./dive -o f").status, 0) << "another dictionary";
  EXPECT_THAT(glidercc("sim --platform hers --no-sbc -o f").err, HasSubstr("no platform `hers`"));
}

TEST_F(PlatformOfFlights, AVehicleWithoutWhatTheHooksNeedIsCheckedAndNotBuilt) {
  platform("s/^name = \"x_hook_answer\"/name = \"x_hook_reply\"/");
  mission("mine.mission", "platform mine\n");
  EXPECT_NE(glidercc("check mine.mission").status, 2);
  for (const std::string command : {"build -o mine ", "sim -o f "}) {
    const Outcome refused = glidercc(command + "mine.mission");
    EXPECT_EQ(refused.status, 2) << refused.err;
    EXPECT_THAT(refused.err, HasSubstr("it has no sensor `x_hook_answer`, which the hooks need"));
  }
  const Outcome header = glidercc("platform mine --header");
  EXPECT_EQ(header.status, 2) << header.out;
  EXPECT_THAT(header.err, HasSubstr("it has no sensor `x_hook_answer`, which the hooks need"));
  EXPECT_EQ(glidercc("platform mine").status, 0) << "it can be looked at";
}

TEST_F(PlatformOfFlights, TheSimulatorsSensorsGoByTheVehiclesNamesNotTheLanguages) {
  platform("/^name = \"m_pitch\"/{s/m_pitch/pitch_x/;n;s/.*/alias = \"m_pitch\"/}");
  mission("mine.mission", "platform mine\n");
  const Outcome flown = glidercc("sim -o f mine.mission");
  EXPECT_EQ(flown.status, 2);
  EXPECT_THAT(flown.err, HasSubstr("has no sensor `m_pitch`"));
}

TEST_F(PlatformOfFlights, WithoutAModelOrFamilyItIsCheckedAndBuiltAndNotFlown) {
  mission("mine.mission", "platform mine\n");
  const auto refused = [&](const std::string& edit, const std::string& why) {
    platform(edit);
    EXPECT_NE(glidercc("check mine.mission").status, 2);
    EXPECT_NE(glidercc("check --scenario default mine.mission").status, 2);
    EXPECT_EQ(glidercc("build mine.mission -o mine").status, 0);
    const Outcome flown = glidercc("sim -o f mine.mission");
    EXPECT_EQ(flown.status, 2) << flown.out << flown.err;
    EXPECT_THAT(flown.err,
                HasSubstr("platform `mine`: the simulator cannot fly this vehicle: " + why));
  };
  refused("/^\\[motion\\]/,/^# The acoustic modem/d", "its file has no [motion]");
  refused("s/^model = .*/model = \"balloon\"/",
          "it has no model `balloon`, only `glider` and `propeller`");
  const std::string unknown = "its file names no `family` that it knows, only `slocum`";
  refused("/^family = /d", unknown);
  refused("s/^family = .*/family = \"propelled\"/", unknown);
}

TEST_F(PlatformOfFlights, ThePlatformsNumbersMoveIt) {
  platform("s/^pump_rate_cc_s = .*/pump_rate_cc_s = 2/");
  mission("slocum.mission", "");
  mission("mine.mission", "platform mine\n");
  const auto deepest = [&](const std::string& name) {
    const Outcome flown = glidercc("sim -o f " + name);
    EXPECT_NE(flown.status, 2) << flown.err;
    return flown.out;
  };
  EXPECT_NE(deepest("slocum.mission"), deepest("mine.mission")) << "a slow pump";
}

TEST_F(PlatformOfFlights, AVehicleThatOnlyHasAnotherNameFliesTheSame) {
  platform("");
  mission("slocum.mission", "");
  mission("mine.mission", "platform mine\n");
  EXPECT_EQ(glidercc(kCampaign + "mine.mission").status, 0);
  ASSERT_EQ(glidercc("sim mine.mission -o a").status, 0);
  ASSERT_EQ(glidercc("sim slocum.mission -o b").status, 0);
  EXPECT_EQ(slurp(folder_.path() / "a" / "trace.csv"), slurp(folder_.path() / "b" / "trace.csv"));
}

TEST_F(PlatformOfFlights, ACampaignIsNotResumedWithAnotherPlatformFile) {
  platform("");
  mission("mine.mission", "platform mine\n");
  ASSERT_EQ(glidercc(kCampaign + "mine.mission").status, 0);
  const std::string resume = "campaign --boards 0 --flights 2 --resume f.csv mine.mission";
  EXPECT_EQ(glidercc(resume).status, 0);
  platform("s/^drift_m_s = .*/drift_m_s = 0.123/");
  const Outcome resumed = glidercc(resume);
  EXPECT_EQ(resumed.status, 2);
  EXPECT_THAT(resumed.err, HasSubstr("GL9373"));
}

TEST_F(PlatformOfFlights, ACheckOfAVehicleThatCannotBeFlownHasItsFindings) {
  mission("mine.mission", "platform mine\nrequire always depth < 18 m\n");
  for (const char* change : {"/^\\[motion\\]/,/^# The acoustic modem/d",
                             "s/^name = \"m_pitch\"/name = \"m_tilt\"/", "/^family = /d"}) {
    platform(change);
    const Outcome checked = glidercc("check --report mine.mission");
    EXPECT_EQ(checked.status, 1) << checked.err;
    EXPECT_THAT(checked.err, HasSubstr("[GL3110 requirement-broken]"));
    EXPECT_THAT(checked.out, HasSubstr("not flown: "));
  }
}

/// Without a family, or with one that is not known: what it does without the SBC is said not to be
/// known, and a mission file is still read as what it is.
TEST_F(PlatformOfFlights, AMissionFileIsCheckedWithAVehicleOfNoKnownFamily) {
  mission("mine.mission", "platform mine\n");
  for (const char* change : {"/^family = /d", "s/^family = .*/family = \"propelled\"/"}) {
    platform(change);
    const Outcome checked = glidercc("check --mi share/scenarios/skeleton.mi mine.mission");
    EXPECT_EQ(checked.status, 0) << checked.err;
    const Outcome report = glidercc("check --report mine.mission");
    EXPECT_THAT(report.out, HasSubstr("names no known family of vehicles"));
    EXPECT_THAT(report.out, Not(HasSubstr("hookbeh revokes control")));
  }
}

}  // namespace
}  // namespace glider::tests
