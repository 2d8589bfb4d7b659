// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// `glidercc log` with the data files of the vehicle.

#include "tests/support/command.h"
#include "tests/unit/slocum/second_reader.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

namespace glider::tests {
namespace {

namespace fs = std::filesystem;
using slocum::second::Draft;

Draft draftOf(const std::string& vehicle) {
  Draft draft;
  draft.full_name = vehicle + "-2024-183-2-7";
  draft.sensors = {{"m_depth", "m", 4, true}, {"m_present_time", "timestamp", 8, true}};
  draft.rows = {
      {{'*', 0}, {'*', 1719946527}}, {{'*', 3.5}, {'*', 1719946531}}, {{}, {'*', 1719946535}}};
  return draft;
}

Outcome logOf(const TemporaryFolder& folder, const std::string& words) {
  return runShell("cd " + folder.path().string() + " && $GLIDERCC log " + words);
}

TEST(DataLog, ShowsFilesAndSensors) {
  const TemporaryFolder folder;
  (void)folder.write("a.sbd", write(draftOf("unit")));
  const Outcome shown = logOf(folder, "a.sbd");
  EXPECT_EQ(shown.status, 0);
  EXPECT_EQ(shown.err, "");
  EXPECT_EQ(shown.out,
            "unit: 1 file, times in UTC\n"
            "  a.sbd  flight   TEST.MI  segment unit-2024-183-2-7, 2024-07-02 18:55:31 to "
            "2024-07-02 18:55:35, 3 records\n"
            "\n"
            "  sensor          unit       updates         min         max        last\n"
            "  m_depth         m                1         3.5         3.5         3.5\n"
            "  m_present_time  timestamp        2  1719946531  1719946535  1719946535\n");
}

TEST(DataLog, SaysThatAFileIsGivenTwice) {
  const TemporaryFolder folder;
  (void)folder.write("a.sbd", write(draftOf("unit")));
  (void)folder.write("copy.sbd", write(draftOf("unit")));
  EXPECT_EQ(logOf(folder, "a.sbd ./a.sbd").err, "glidercc: note: `./a.sbd` is given twice\n");
  EXPECT_EQ(logOf(folder, "a.sbd copy.sbd").err,
            "glidercc: note: `copy.sbd` is left out: `a.sbd` has the same segment\n");
}

/// The library of netCDF is found as any other. Here another file has its name.
TEST(DataLog, SaysWhyItCannotWriteNetcdf) {
  const TemporaryFolder folder;
  (void)folder.write("a.sbd", write(draftOf("unit")));
  const std::string name = GLIDER_NETCDF;
  const auto log = [&](const std::string& arguments) {
    return runShell("cd " + folder.path().string() + " && LD_LIBRARY_PATH=. $GLIDERCC log a.sbd " +
                    arguments);
  };
  (void)folder.write(name, "");
  const Outcome broken = log("--netcdf o.nc");
  EXPECT_EQ(broken.status, 2);
  EXPECT_NE(broken.err.find("cannot write `o.nc`: "), std::string::npos) << broken.err;
  EXPECT_NE(broken.err.find(name + ": file too short"), std::string::npos) << broken.err;
  EXPECT_FALSE(fs::exists(folder.path() / "o.nc"));
  EXPECT_EQ(log("--csv o.csv").status, 0) << "nothing else needs it";
  fs::copy_file(GLIDER_ANY_LIBRARY, folder.path() / name, fs::copy_options::overwrite_existing);
  const Outcome another = log("--netcdf o.nc");
  EXPECT_EQ(another.status, 2);
  EXPECT_NE(another.err.find(name + " has no nc_"), std::string::npos) << another.err;
  EXPECT_FALSE(fs::exists(folder.path() / "o.nc"));
}

TEST(DataLog, WritesTheSensorsAskedFor) {
  const TemporaryFolder folder;
  (void)folder.write("a.sbd", write(draftOf("unit")));
  const Outcome csv = logOf(folder, "--sensors 'm_d*' --csv - .");
  EXPECT_EQ(csv.status, 0) << csv.err;
  EXPECT_EQ(csv.out, "time_s,computer,m_depth\n1719946531,flight,3.5\n1719946535,flight,\n");
  // accepts: GL9364 GL9365
  EXPECT_EQ(logOf(folder, "a.sbd --sensors m_depth,m_present_time --netcdf o.nc").status, 0);
  EXPECT_EQ(slurp(folder.path() / "o.nc").substr(1, 3), "HDF");
  const Outcome unknown = logOf(folder, "a.sbd --sensors m_deph");
  EXPECT_EQ(unknown.status, 2);
  EXPECT_NE(unknown.err.find("[GL9364 "), std::string::npos) << unknown.err;
}

TEST(DataLog, DamageEndsWithOneAndShowsTheRest) {
  const TemporaryFolder folder;
  const std::string bytes = write(draftOf("unit"));
  (void)folder.write("a.sbd", bytes.substr(0, bytes.size() - 5));
  const Outcome shown = logOf(folder, "a.sbd");
  EXPECT_EQ(shown.status, 1);
  EXPECT_NE(shown.out.find("2 records\n"), std::string::npos) << shown.out;
  EXPECT_NE(shown.err.find("the file ends within a record"), std::string::npos) << shown.err;
  EXPECT_NE(shown.err.find("[GL5203 "), std::string::npos) << shown.err;
}

TEST(DataLog, MissingFilesAndListsEndWithTwo) {
  const TemporaryFolder folder;
  Draft draft = draftOf("unit");
  draft.factored = true;
  (void)folder.write("a.sbd", write(draft));
  const Outcome missing = logOf(folder, "a.sbd");
  EXPECT_EQ(missing.status, 2);
  EXPECT_NE(missing.err.find("[GL5201 "), std::string::npos) << missing.err;
  fs::create_directory(folder.path() / "lists");
  (void)folder.write("lists/" + slocum::second::crcOf(listText(draft)) + ".cac", listText(draft));
  EXPECT_EQ(logOf(folder, "--cache none --cache lists a.sbd").status, 0);
  EXPECT_EQ(logOf(folder, "a.sbd none.sbd --cache lists").status, 2);
  fs::create_directory(folder.path() / "empty");
  EXPECT_EQ(logOf(folder, "empty").status, 2);
}

TEST(DataLog, TablesAreOfOneVehicle) {
  const TemporaryFolder folder;
  (void)folder.write("a.sbd", write(draftOf("unit")));
  (void)folder.write("b.sbd", write(draftOf("other")));
  const Outcome shown = logOf(folder, ".");
  EXPECT_EQ(shown.status, 0);
  EXPECT_TRUE(shown.out.starts_with("other: 1 file")) << shown.out;
  EXPECT_NE(shown.out.find("\nunit: 1 file"), std::string::npos) << shown.out;
  const Outcome csv = logOf(folder, ". --csv o.csv");
  EXPECT_EQ(csv.status, 2);
  EXPECT_NE(csv.err.find("[GL9365 "), std::string::npos) << csv.err;
}

TEST(DataLog, NeverOverwritesItsInput) {
  const TemporaryFolder folder;
  const std::string bytes = write(draftOf("unit"));
  const auto path = folder.write("a.sbd", bytes);
  for (const std::string& option :
       std::vector<std::string>{"--csv", "--netcdf", "--report", "--picture"}) {
    const Outcome refused = logOf(folder, "a.sbd " + option + " ./a.sbd");
    EXPECT_EQ(refused.status, 2);
    EXPECT_NE(refused.err.find("[GL9350 "), std::string::npos) << refused.err;
  }
  EXPECT_EQ(slurp(path), bytes);
}

TEST(DataLog, OptionsOfDataFilesAreNotForMissionLogs) {
  const TemporaryFolder folder;
  (void)folder.write("mission.log", "hello");
  for (const std::string& option :
       std::vector<std::string>{"--netcdf o.nc", "--report o.html", "--picture o.svg"}) {
    const Outcome refused = logOf(folder, "mission.log " + option);
    EXPECT_EQ(refused.status, 2);
    EXPECT_NE(refused.err.find("[GL5200 "), std::string::npos) << refused.err;
    EXPECT_NE(refused.err.find("only `--csv`, `--mission` and `--format` can be used"),
              std::string::npos);
  }
  EXPECT_NE(logOf(folder, "mission.log").err.find("[GL9363 "), std::string::npos);
}

/// A dive to 40 m and back, a record every 20 s.
Draft diveOf(const std::string& vehicle) {
  Draft draft = draftOf(vehicle);
  draft.rows.resize(1);
  for (int i = 0; i <= 60; ++i) {
    const double depth = i < 10 || i > 50 ? 0.5 : 40.0 - 2.0 * std::abs(i - 30);
    draft.rows.push_back({{'*', depth}, {'*', 1719946531.0 + 20 * i}});
  }
  return draft;
}

const char* const kFlight =
    "time (s),missiontime (s),m_depth (m),m_pitch (rad)\n0,,0,\n4,,3,0.1\n30,,33,\n";

TEST(DataLogReport, WritesThePageAndThePicture) {
  const TemporaryFolder folder;
  (void)folder.write("a.sbd", write(diveOf("unit")));
  // accepts: GL5204 GL9366 GL9367
  const Outcome drawn = logOf(folder, "a.sbd --report p.html --picture p.svg --csv o.csv");
  EXPECT_EQ(drawn.status, 0) << drawn.err;
  EXPECT_EQ(drawn.out, "");
  const std::string page = slurp(folder.path() / "p.html");
  EXPECT_NE(page.find("<title>unit: TEST.MI</title>"), std::string::npos);
  EXPECT_NE(page.find("\"beside\":\"\""), std::string::npos);
  EXPECT_NE(page.find("left the surface"), std::string::npos);
  EXPECT_NE(slurp(folder.path() / "p.svg").find(">unit: TEST.MI</text>"), std::string::npos);
  EXPECT_TRUE(slurp(folder.path() / "o.csv").starts_with("time_s,computer,m_depth,"));
}

TEST(DataLogReport, DrawsASimulatedFlightBeside) {
  const TemporaryFolder folder;
  (void)folder.write("a.sbd", write(diveOf("unit")));
  (void)folder.write("f.csv", kFlight);
  const Outcome drawn = logOf(folder, "a.sbd --beside f.csv --report p.html --picture p.svg");
  EXPECT_EQ(drawn.status, 0) << drawn.err;
  const std::string page = slurp(folder.path() / "p.html");
  EXPECT_NE(page.find("\"beside\":\"f.csv\""), std::string::npos);
  EXPECT_NE(page.find("sim_depth"), std::string::npos);
  EXPECT_NE(slurp(folder.path() / "p.svg").find("simulated flight"), std::string::npos);
  EXPECT_EQ(logOf(folder, "a.sbd --beside f.csv").status, 2) << "there is nothing to draw it in";
}

/// Checks that drawing `words` fails with 2 and `code`, and writes nothing.
void expectRefused(const TemporaryFolder& folder, const std::string& words,
                   const std::string& code) {
  const Outcome refused = logOf(folder, words + " --report p.html");
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.err.find("[" + code + " "), std::string::npos) << refused.err;
  EXPECT_FALSE(fs::exists(folder.path() / "p.html"));
}

TEST(DataLogReport, WhatCannotBeDrawnIsRefused) {
  const TemporaryFolder folder;
  (void)folder.write("a.sbd", write(diveOf("unit")));
  (void)folder.write("b.sbd", write(diveOf("other")));
  (void)folder.write("bad.csv", "hello\n");
  (void)folder.write("flat.csv", "time (s),m_depth (m)\n0,0\n4,1\n");
  Draft blind = diveOf("unit");
  blind.sensors[0].name = "m_pitch";
  (void)folder.write("blind.sbd", write(blind));
  expectRefused(folder, "a.sbd b.sbd", "GL9365");
  expectRefused(folder, "blind.sbd", "GL5204");
  expectRefused(folder, "a.sbd --beside bad.csv", "GL9366");
  expectRefused(folder, "a.sbd --beside flat.csv", "GL9367");
  expectRefused(folder, "a.sbd --beside none.csv", "GL9001");
}

TEST(DataLogReport, NeverOverwritesTheFlightBeside) {
  const TemporaryFolder folder;
  (void)folder.write("a.sbd", write(diveOf("unit")));
  const auto path = folder.write("f.csv", kFlight);
  EXPECT_EQ(logOf(folder, "a.sbd --beside f.csv --picture ./f.csv").status, 2);
  EXPECT_EQ(slurp(path), kFlight);
}

TEST(DataLogReport, AnAbortIsOnThePageAndTheCommandSucceeds) {
  const TemporaryFolder folder;
  Draft draft = diveOf("unit");
  draft.sensors.push_back({"x_mission_status", "enum", 1, true});
  for (size_t i = 0; i < draft.rows.size(); ++i) {
    draft.rows[i].push_back({'*', i < 30 ? 0.0 : 7.0});
  }
  (void)folder.write("a.sbd", write(draft));
  const Outcome drawn = logOf(folder, "a.sbd --report p.html");
  EXPECT_EQ(drawn.status, 0) << drawn.err;
  EXPECT_NE(slurp(folder.path() / "p.html")
                .find("the vehicle aborted at 2024-07-02 19:05:11 UTC: too deep, mission status 7"),
            std::string::npos);
}

TEST(DataLogReport, ASimulatedFlightIsDrawnBesideARealOne) {
  const fs::path real = fs::path(GLIDER_SOURCE_DIR) / "../shared/data/dbd";
  if (!fs::exists(real)) {
    GTEST_SKIP() << "the real data files are not here: " << real;
  }
  const TemporaryFolder folder;
  const std::string mission =
      (real / "../missions/comet-and-helgoland/nsb3/nsb3.mi").lexically_normal().string();
  // Wherever its waypoints are, the simulated glider dives.
  (void)folder.write("there.toml",
                     "name = \"there\"\nskeleton = \"skeleton.mi\"\nduration_s = 3600\n"
                     "[start]\nlatitude_deg = 54.3161\nlongitude_deg = 7.4098\n"
                     "[ocean]\nwater_depth_m = 45.0\n");
  fs::copy_file(fs::path(GLIDER_SOURCE_DIR) / "scenarios/skeleton.mi",
                folder.path() / "skeleton.mi");
  const Outcome flown = runShell("cd " + folder.path().string() + " && $GLIDERCC sim " + mission +
                                 " --scenario there.toml -o flight");
  ASSERT_EQ(flown.status, 0) << flown.err;
  const std::string log = (real / "comet-2019-222-02-154").string();
  const Outcome drawn =
      logOf(folder, log + ".dbd " + log + ".ebd --beside flight/trace.csv --report p.html");
  EXPECT_EQ(drawn.status, 0) << drawn.err;
  EXPECT_NE(slurp(folder.path() / "p.html").find("<title>comet: NSB3.MI</title>"),
            std::string::npos);
}

/// The lines below `    $ COMMAND` in the guide, without their indentation, up to an empty line
/// that text follows.
std::string guideOutput(const std::string& command) {
  const std::string page = slurp(fs::path(GLIDER_SOURCE_DIR) / "docs/guide.md");
  const std::string prompt = "    $ " + command + "\n";
  std::string text;
  size_t at = page.find(prompt);
  EXPECT_NE(at, std::string::npos) << command;
  for (at += prompt.size(); at < page.size();) {
    const std::string line = page.substr(at, page.find('\n', at) - at);
    if (!line.empty() && !line.starts_with("    ")) {
      break;
    }
    text += (line.empty() ? "" : line.substr(4)) + "\n";
    at += line.size() + 1;
  }
  return text.substr(0, text.find_last_not_of('\n') + 1) + "\n";
}

TEST(DataLog, TheGuideShowsWhatRealFilesGive) {
  const fs::path real = fs::path(GLIDER_SOURCE_DIR) / "../shared/data/dbd";
  if (!fs::exists(real)) {
    GTEST_SKIP() << "the real data files are not here: " << real;
  }
  for (const std::string& command : std::vector<std::string>{
           "glidercc log comet-2019-218-00-033.sbd comet-2019-218-00-033.tbd",
           "glidercc log comet-2019-218-00-033.sbd comet-2019-218-00-033.tbd --sensors "
           "'m_depth,sci_water*' --csv -"}) {
    const Outcome shown =
        runShell("cd " + real.string() + " && " + "$GLIDERCC" + command.substr(8));
    EXPECT_EQ(shown.out, guideOutput(command));
    EXPECT_EQ(shown.status, 0) << shown.err;
  }
}

TEST(DataLogReport, TheCommandsOfTheGuideDrawRealFiles) {
  const fs::path real = fs::path(GLIDER_SOURCE_DIR) / "../shared/data/dbd";
  if (!fs::exists(real)) {
    GTEST_SKIP() << "the real data files are not here: " << real;
  }
  const TemporaryFolder folder;
  for (const char* name : {"comet-2019-218-00-034.dbd", "comet-2019-218-00-034.ebd", "cac"}) {
    fs::create_symlink(real / name, folder.path() / name);
  }
  fs::create_directory(folder.path() / "flight");
  (void)folder.write("flight/trace.csv", kFlight);
  const std::string page = slurp(fs::path(GLIDER_SOURCE_DIR) / "docs/guide.md");
  const std::string files = "comet-2019-218-00-034.dbd comet-2019-218-00-034.ebd ";
  for (const std::string& words : {files + "--report comet.html --picture comet.svg",
                                   files + "--beside flight/trace.csv --report comet.html"}) {
    EXPECT_NE(page.find("    glidercc log " + words + "\n"), std::string::npos) << words;
    const Outcome drawn = logOf(folder, words);
    EXPECT_EQ(drawn.status, 0) << drawn.err;
  }
  EXPECT_NE(slurp(folder.path() / "comet.html").find("<title>comet: SPIRAL.MI</title>"),
            std::string::npos);
  EXPECT_NE(slurp(folder.path() / "comet.svg").find("</svg>"), std::string::npos);
}

}  // namespace
}  // namespace glider::tests
