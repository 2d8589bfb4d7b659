// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The mission's log on a board outlives the program: a reboot in the middle of a flight keeps it.

#include "tests/flights/flight.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace glider::tests {
namespace {

size_t countOf(const std::string& text, const std::string& part) {
  size_t count = 0;
  for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++count;
  }
  return count;
}

/// `glidercc log --csv` of a file.
std::string csvOf(const TemporaryFolder& folder, const std::string& log) {
  const std::string csv = (folder.path() / "log.csv").string();
  const Outcome outcome = runShell("$GLIDERCC log " + log + " --csv " + csv);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  return slurp(csv);
}

/// What `sim` is given to fly Figure 2's program of this computer with `options`.
std::string flightThatLogs(const TemporaryFolder& folder, const std::string& options) {
  const std::string program = (folder.path() / "figure2").string();
  const auto sbc = folder.write("sbc", "#!/bin/sh\nexec " + program + " " + options + " \"$@\"\n");
  const Outcome built = runShell("$GLIDERCC build " + project("missions/figure2.mission") + " -o " +
                                 program + " && chmod +x " + sbc.string());
  EXPECT_EQ(built.status, 0) << built.err;
  return "--sbc " + sbc.string() + " --scenario " + project("scenarios/default.toml");
}

TEST(MissionLog, AProgramThatStartsAgainWritesAfterTheOldLog) {
  const TemporaryFolder folder;
  const std::string log = (folder.path() / "figure2.log").string();
  const std::string flight = flightThatLogs(folder, "--log " + log);
  ASSERT_EQ(fly(flight).outcome.status, 0);
  const std::string first = slurp(log), first_csv = csvOf(folder, log);
  EXPECT_EQ(countOf(first_csv, ",start,"), 1U);
  std::ofstream(log, std::ios::app) << first.substr(first.size() / 2, 9);  // the power was cut here
  ASSERT_EQ(fly(flight).outcome.status, 0);
  const std::string both = csvOf(folder, log);
  EXPECT_EQ(both.substr(0, first_csv.size()), first_csv);
  EXPECT_EQ(both.substr(first_csv.size()), first_csv.substr(first_csv.find('\n') + 1));
  const Outcome told = runShell("$GLIDERCC log " + log);
  EXPECT_EQ(told.err,
            "glidercc: note: " + log + ": records: 1 incomplete or damaged and skipped\n");
  EXPECT_EQ(told.status, 0);
}

TEST(MissionLog, AllThatIsWrongWithItIsReported) {
  const TemporaryFolder folder;
  const std::string log = (folder.path() / "figure2.log").string();
  ASSERT_EQ(fly(flightThatLogs(folder, "--log " + log)).outcome.status, 0);
  const std::string whole = slurp(log);
  const size_t third = whole.find('\0', whole.find('\0', 1) + 1) + 1;
  const size_t fourth = whole.find('\0', third) + 1;
  std::ofstream(log, std::ios::binary)
      << whole.substr(0, third) << whole.substr(fourth) << "torn";  // one is missing
  EXPECT_EQ(runShell("$GLIDERCC log " + log).err,
            "glidercc: note: " + log +
                ": records: 1 incomplete or damaged and skipped, 1 missing (or more, by a "
                "multiple of 256)\n");
}

TEST(MissionLog, AFullOneBecomesTheOlderOne) {
  const TemporaryFolder folder;
  const std::string log = (folder.path() / "figure2.log").string();
  ASSERT_EQ(fly(flightThatLogs(folder, "--log " + log + " --log-limit 9000")).outcome.status, 0);
  EXPECT_LT(slurp(log).size(), 11100U);
  EXPECT_LT(slurp(log + ".old").size(), 11100U);
  EXPECT_GT(slurp(log + ".old").size(), 8999U);
  const std::string older = csvOf(folder, log + ".old"), newer = csvOf(folder, log);
  EXPECT_NE(newer.find("2500,transition,exit,1,s3,"), std::string::npos);
  EXPECT_NE(older.find(",value,depth,"), std::string::npos);
  EXPECT_EQ((older + newer).find("?"), std::string::npos) << "each names what it holds";
}

TEST(MissionLog, TheSimulatorsIsOfOneFlight) {
  const TemporaryFolder folder;
  const std::string output = (folder.path() / "flight").string();
  const std::string sim = "$GLIDERCC sim " + project("missions/figure2.mission") +
                          " --board host -o " + output + " --scenario " +
                          project("scenarios/default.toml");
  ASSERT_EQ(runShell(sim).status, 0);
  const std::string first = slurp(output + "/mission.log");
  EXPECT_EQ(countOf(csvOf(folder, output + "/mission.log"), ",start,"), 1U);
  ASSERT_EQ(runShell(sim).status, 0);
  EXPECT_EQ(slurp(output + "/mission.log"), first);
}

TEST(MissionLog, IsTheSameOnEveryBoardAndTellsWhatFired) {
  std::string host;
  for (const char* board : {"host", "ts7800", "ts5500", "pizero2", "cm4"}) {
    const TemporaryFolder folder;
    const std::string output = (folder.path() / "flight").string();
    ASSERT_EQ(runShell("$GLIDERCC sim " + project("missions/figure2.mission") + " --board " +
                       board + " -o " + output + " --scenario " + project("scenarios/default.toml"))
                  .status,
              0);
    const Outcome told = runShell("$GLIDERCC log " + output + "/mission.log");
    EXPECT_EQ(told.status, 0);
    EXPECT_EQ(told.err, "");
    EXPECT_NE(told.out.find("1500.0 s  s2 → s1 (return, case 1): statetime 1000, resumetime 1000, "
                            "m_depth "),
              std::string::npos)
        << told.out;
    host = host.empty() ? told.out : host;
    EXPECT_EQ(told.out, host) << board;
  }
}

constexpr const char* kPlaceMission = R"(mission place

param home : position = 39 10.5 N 73 49.8 W
param below : length = 0.5 km in 0 m .. 1 km

state dive
begin
  flightroute   heading(90 deg)
  flightprofile yo(2 m, 15 m, 26 deg, 26 deg)
  sensors       depth, m_battery
  entry do log "from", home, depth, temp end
  events
    case statetime > 100 s && depth < below exit
end
)";

/// Flies kPlaceMission on a board, in `folder`; returns its log.
std::string flyPlace(const TemporaryFolder& folder) {
  const auto mission = folder.write("place.mission", kPlaceMission);
  const std::string output = (folder.path() / "flight").string();
  const Outcome flown = runShell("$GLIDERCC sim " + mission.string() + " --board host -o " +
                                 output + " --scenario " + project("scenarios/default.toml"));
  EXPECT_EQ(flown.status, 0) << flown.err;
  return output + "/mission.log";
}

TEST(MissionLog, HasTheUnitsOfTheMissionThatWroteItInItsTablesToo) {
  const TemporaryFolder folder;
  const std::string log = flyPlace(folder);
  const auto mission = folder.path() / "place.mission";
  const Outcome csv = runShell("$GLIDERCC log " + log + " --csv - --mission " + mission.string());
  for (const char* part :
       {"time_s,record,name,value,from,to,unit\n0,start,place,,,,\n0,begin,,,,,\n",
        "0,parameter,home.latitude,39.175,,,deg\n", "0,parameter,below,500,,,m\n", ",,,V\n",
        "104,transition,exit,1,dive,,\n", "104,fired,statetime,104,,,s\n", ",,,degC\n"}) {
    EXPECT_NE(csv.out.find(part), std::string::npos) << part << "\n" << csv.out;
  }
  const Outcome json =
      runShell("$GLIDERCC log " + log + " --format json --mission " + mission.string());
  EXPECT_NE(json.out.find("\"unit\": \"degC\""), std::string::npos);
}

TEST(MissionLog, HasTheUnitsOfTheMissionThatWroteIt) {
  const TemporaryFolder folder;
  const std::string log = flyPlace(folder);
  const auto mission = folder.path() / "place.mission";
  const Outcome told = runShell("$GLIDERCC log " + log + " --mission " + mission.string());
  EXPECT_EQ(told.status, 0) << told.err;  // accepts: GL9395
  for (const char* part :
       {"the mission begins: home 39 10.500 N 73 49.800 W, below 500 m\n",
        "log from: 39 10.500 N 73 49.800 W, ", " degC\n", " m, m_battery 1", " V\n", " degC, m_gps",
        "dive → end (exit, case 1): statetime 1 min 44 s, resumetime 1 min 44 s, m_depth 12.586 "
        "m, m_battery 14.241 V, sci_water_temp 19.154 degC"}) {
    EXPECT_NE(told.out.find(part), std::string::npos) << part << "\n" << told.out;
  }
  EXPECT_NE(
      runShell("$GLIDERCC log " + log).out.find("home.latitude 39.175, home.longitude -73.83"),
      std::string::npos);
  // Another version of the mission.
  std::string text = kPlaceMission;
  text.replace(text.find("\"from\""), 6, "\"at\"");
  const auto edited = folder.write("edited.mission", text);
  const Outcome strange = runShell("$GLIDERCC log " + log + " --mission " + edited.string());
  EXPECT_EQ(strange.err, "glidercc: note: " + log + ": 1 entry with names or texts that " +
                             edited.string() +
                             " does not have: another version of the mission wrote it\n");
  EXPECT_NE(strange.out.find("log from: 39.175, -73.83, "), std::string::npos) << strange.out;
  const Outcome other =
      runShell("$GLIDERCC log " + log + " --mission " + project("missions/figure2.mission"));
  EXPECT_EQ(other.status, 2);  // rejects: GL9395
  EXPECT_NE(other.err.find("is the log of mission place, not of mission "), std::string::npos)
      << other.err;
  EXPECT_EQ(other.out, "");
}

TEST(MissionLog, WhatIsNoneIsRefused) {  // GL9363
  const TemporaryFolder folder;          // accepts: GL9363 above
  const auto empty = folder.write("empty", "");
  const auto text = folder.write("text", "time_s,record,name,value,from,to\n0,mission,bench,,,\n");
  const auto zeros = folder.write("zeros", std::string(100000, '\0'));
  const auto noise = folder.write("noise", std::string(100000, '\x55'));
  for (const auto& file : {empty, text, zeros, noise}) {
    const Outcome outcome = runShell("$GLIDERCC log " + file.string());
    EXPECT_EQ(outcome.status, 2) << file;
    EXPECT_NE(outcome.err.find("[GL9363 no-log]"), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.out, "");
  }
  EXPECT_EQ(runShell("$GLIDERCC log " + (folder.path() / "nothing").string()).status, 2);
  EXPECT_EQ(runShell("$GLIDERCC log").status, 2);
}

}  // namespace
}  // namespace glider::tests
