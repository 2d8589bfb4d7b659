// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Several vehicles in one sea: `glidercc sim` and `check` of a fleet file.

#include "tests/support/command.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <gmock/gmock.h>
#include <string>

namespace glider::tests {
namespace {

using testing::HasSubstr;
using testing::Not;

class FleetCommand : public ::testing::Test {
 protected:
  /// A mission that stays about a place.
  void mission(const std::string& name, const std::string& latitude,
               const std::string& area = "6 km") const {
    (void)folder_.write(name + ".mission", "mission " + name + R"(
require always distance()" + latitude + R"( N 73.83 W) <= )" +
                                               area + R"(
assume current <= 0.2 m/s
param bottom : length = 20 m in 10 m .. 40 m
state out
begin
  flightroute   nav()" + latitude + R"( N 73.83 W)
  flightprofile yo(5 m, bottom)
  sensors       missiontime, depth
  events
    case missiontime >= 20 min exit
end
)");
  }
  static std::string vehicle(const std::string& name, const std::string& mission,
                             const std::string& more = "") {
    return "[[vehicle]]\nname = \"" + name + "\"\nmission = \"" + mission + ".mission\"\n" + more;
  }
  [[nodiscard]] Outcome run(const std::string& arguments) const {
    return runShell("cd " + folder_.path().string() + " && " + arguments);
  }
  [[nodiscard]] std::string slurped(const std::string& file) const {
    return slurp(folder_.path() / file);
  }

  const TemporaryFolder folder_;
};

const std::string kNorth = "latitude_deg = 39.26\nlongitude_deg = -73.83\n";
const std::string kSouth = "latitude_deg = 39.10\nlongitude_deg = -73.83\n";

// accepts: GL9303, GL9394
TEST_F(FleetCommand, FliesAllAndEachAsItDoesAlone) {
  mission("up", "39.26");
  mission("down", "39.10");
  (void)folder_.write("f.toml", "separation_m = 500\n" + vehicle("a", "up", kNorth) +
                                    vehicle("b", "down", kSouth + "set = [\"bottom = 30 m\"]\n"));
  const Outcome all = run("$GLIDERCC sim f.toml -o all");
  EXPECT_EQ(all.status, 0) << all.err;
  EXPECT_THAT(all.out, HasSubstr("nearest: a and b were 177"));  // 0.16 degrees: 17.7 km
  EXPECT_THAT(all.out, HasSubstr("report: all/report.html"));
  const Outcome alone = run("$GLIDERCC sim f.toml --only b -o alone");
  EXPECT_EQ(alone.status, 0) << alone.err;
  EXPECT_EQ(slurped("all/b/trace.csv"), slurped("alone/b/trace.csv"));
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "alone/a"));
  const auto summary = nlohmann::json::parse(slurped("all/flight.json"));
  EXPECT_EQ(summary["vehicles"][1]["name"], "b");
  EXPECT_GT(summary["vehicles"][1]["figures"]["deepest"], 28) << "by its own parameter";
  EXPECT_LT(summary["vehicles"][0]["figures"]["deepest"], 25);
  EXPECT_THAT(slurped("all/report.html"), HasSubstr("<a href=\"b/report.html\">b</a>"));
  EXPECT_THAT(slurped("all/distances.csv"), HasSubstr("time (s),a-b (m)\n"));
  EXPECT_EQ(run("$GLIDERCC sim f.toml -o all").status, 0) << "it replaces an earlier one";
}

TEST_F(FleetCommand, AFleetOfOneAtTheUsualStartFliesAsTheMissionDoes) {
  mission("up", "39.18");
  (void)folder_.write("f.toml", vehicle("a", "up"));
  EXPECT_EQ(run("$GLIDERCC sim f.toml -o fleet && $GLIDERCC sim up.mission -o one").status, 0);
  EXPECT_EQ(slurped("fleet/a/trace.csv"), slurped("one/trace.csv"));
  EXPECT_EQ(slurped("fleet/a/report.html"), slurped("one/report.html"));
}

// rejects: GL9394
TEST_F(FleetCommand, VehiclesThatComeTooNearAreReported) {
  mission("up", "39.18");
  (void)folder_.write("f.toml", "separation_m = 200\n" + vehicle("a", "up") +
                                    vehicle("b", "up", "bearing_deg = 90\ndistance_m = 150\n"));
  const Outcome near = run("$GLIDERCC sim f.toml -o f");
  EXPECT_EQ(near.status, 1);
  EXPECT_THAT(near.err, HasSubstr("a and b were "));
  EXPECT_THAT(near.err, HasSubstr("the fleet requires 200 m [GL9394"));
  EXPECT_THAT(slurped("f/report.html"), HasSubstr("200 m are required."));
}

TEST_F(FleetCommand, TheCheckProvesWhatAreasAreApart) {
  mission("up", "39.26");
  mission("down", "39.10");
  mission("wide", "39.12", "30 km");
  (void)folder_.write("f.toml", "separation_m = 500\n" + vehicle("a", "up", kNorth) +
                                    vehicle("b", "down", kSouth) + vehicle("c", "wide"));
  const Outcome checked = run("$GLIDERCC check f.toml");
  EXPECT_EQ(checked.status, 0) << checked.err;
  EXPECT_THAT(checked.out, HasSubstr("proved: a and b are always 55"));  // 17.7 km less 12 km
  EXPECT_THAT(checked.out, HasSubstr("undecided: 500 m between a and c: their areas overlap\n"));
  EXPECT_THAT(checked.out,
              HasSubstr("f.toml: fleet of 3 vehicles, 3 missions, separation proved for 1 of 3"));
  EXPECT_EQ(run("$GLIDERCC check --strict f.toml").status, 1);
  const auto document = nlohmann::json::parse(run("$GLIDERCC check --format json f.toml").out);
  EXPECT_EQ(document["fleet"]["pairs"][0]["verdict"], "proved");
  EXPECT_EQ(document["fleet"]["pairs"][1]["reason"], "their areas overlap");
}

/// The proof of an area rests on where control is given, and the fleet file says where.
TEST_F(FleetCommand, AStartAgainstThePremiseOfAProofLeavesItUndecided) {
  mission("up", "39.26");
  mission("down", "39.10");
  const auto undecided = [&](const std::string& start) {
    (void)folder_.write("f.toml", "separation_m = 500\n" + vehicle("a", "up", kNorth) +
                                      vehicle("b", "down", start));
    return run("$GLIDERCC check f.toml").out;
  };
  const std::string west = "longitude_deg = -73.83\n";
  EXPECT_THAT(undecided("latitude_deg = 39.26\n" + west),
              HasSubstr("undecided: 500 m between a and b: b starts outside the area in which "
                        "`down.mission` stays\n"));
  EXPECT_THAT(undecided("latitude_deg = 39.149\n" + west),  // 5.4 km of 6
              HasSubstr("b starts within 524 m of the edge of its area; "));
  EXPECT_THAT(undecided("latitude_deg = 39.149\n" + west), HasSubstr(" m are needed\n"));
  EXPECT_THAT(undecided(kSouth), HasSubstr("proved: a and b are always"));
}

TEST_F(FleetCommand, WhatIsNotProvedOfOneMissionProvesNothingOfTheFleet) {
  mission("up", "39.26");
  mission("down", "39.10", "1 km");  // the drift in 20 minutes is more
  (void)folder_.write(
      "f.toml", "separation_m = 500\n" + vehicle("a", "up", kNorth) + vehicle("b", "down", kSouth));
  EXPECT_THAT(run("$GLIDERCC check f.toml").out,
              HasSubstr("undecided: 500 m between a and b: it is not proved that `down.mission` "
                        "stays in its area\n"));
}

TEST_F(FleetCommand, AStartMustBeWhereTheMissionAssumesIt) {
  mission("up", "39.26");
  mission("down", "39.10");
  (void)folder_.write("down.mission", slurped("down.mission") +
                                          "assume start distance(39.11 N 73.83 W) <= 300 m\n");
  const auto checked = [&](const std::string& start) {
    (void)folder_.write("f.toml", "separation_m = 500\n" + vehicle("a", "up", kNorth) +
                                      vehicle("b", "down", start));
    return run("$GLIDERCC check f.toml").out;
  };
  EXPECT_THAT(checked(kSouth), HasSubstr("b does not start where `down.mission` assumes it\n"));
  EXPECT_THAT(checked("latitude_deg = 39.11\nlongitude_deg = -73.83\n"),
              HasSubstr("proved: a and b are always"));
}

TEST_F(FleetCommand, MistakesInAMissionAreShownWithItsFile) {
  mission("up", "39.26");
  (void)folder_.write("bad.mission", "mission bad\nstate s\nbegin\nend end\n");
  (void)folder_.write("f.toml",
                      "separation_m = 9\n" + vehicle("a", "up", kNorth) + vehicle("b", "bad"));
  for (const char* command : {"check", "sim"}) {
    const Outcome wrong = run("$GLIDERCC " + std::string(command) + " f.toml");
    EXPECT_EQ(wrong.status, 1) << command;
    EXPECT_THAT(wrong.err, HasSubstr("bad.mission:4:")) << command;
  }
  EXPECT_THAT(run("$GLIDERCC check f.toml").out,
              HasSubstr("undecided: 9 m between a and b: `bad.mission` has errors"));
}

TEST_F(FleetCommand, SettingsThatAMissionDoesNotAllowNameTheVehicle) {
  mission("up", "39.26");
  (void)folder_.write("f.toml", vehicle("a", "up", "set = [\"bottom = 900 m\"]\n"));
  for (const char* command : {"check", "sim"}) {
    const Outcome wrong = run("$GLIDERCC " + std::string(command) + " f.toml");
    EXPECT_EQ(wrong.status, 2) << command;
    EXPECT_THAT(wrong.err, HasSubstr("vehicle `a`: ")) << command;
    EXPECT_THAT(wrong.err, HasSubstr("GL9052")) << command;
  }
}

// rejects: GL9303
TEST_F(FleetCommand, WhatAFleetDoesNotHaveIsRefused) {
  mission("up", "39.26");
  (void)folder_.write("f.toml", vehicle("a", "up") + vehicle("b", "up"));
  const Outcome other = run("$GLIDERCC sim f.toml --only c");
  EXPECT_EQ(other.status, 2);
  EXPECT_THAT(other.err, HasSubstr("has no vehicle `c` [GL9303"));
  EXPECT_THAT(other.err, HasSubstr("its vehicles are a, b"));
  const Outcome board = run("$GLIDERCC sim f.toml --board ts7800");
  EXPECT_EQ(board.status, 2);
  EXPECT_THAT(board.err, HasSubstr("a fleet file excludes --board"));
  EXPECT_EQ(run("$GLIDERCC sim up.mission --only a").status, 2);
  EXPECT_EQ(run("$GLIDERCC sim missing.toml").status, 2);
}

/// The example of docs/fleets.md.
TEST_F(FleetCommand, TheExampleIsProvedAndFlies) {
  const std::string example = GLIDER_SOURCE_DIR "/missions/fleet/two_areas.toml";
  const Outcome checked = run("$GLIDERCC check --strict " + example);
  EXPECT_EQ(checked.status, 0) << checked.err;
  EXPECT_THAT(checked.out, HasSubstr("proved: comet and otter are always 1548 m apart or more\n"));
  const Outcome flown = run("$GLIDERCC sim " + example + " -o f");
  EXPECT_EQ(flown.status, 0) << flown.err;
  EXPECT_THAT(flown.out, HasSubstr("nearest: comet and otter were 12495 m apart"));
}

TEST_F(FleetCommand, ItsPictureShowsDepthsDistancesOrTracks) {
  mission("up", "39.18");
  (void)folder_.write(
      "f.toml", vehicle("a", "up") + vehicle("b", "up", "bearing_deg = 90\ndistance_m = 500\n"));
  for (const auto& [chart, axis] : {std::pair("", "depth (m)"),
                                    {"--chart distances", "distance (m)"},
                                    {"--chart tracks", "north (m)"}}) {
    const Outcome flown = run("$GLIDERCC sim f.toml -o f --picture f/p.svg " + std::string(chart));
    EXPECT_EQ(flown.status, 0) << flown.err;
    EXPECT_THAT(slurped("f/p.svg"), HasSubstr(axis));
  }
  EXPECT_EQ(run("$GLIDERCC sim f.toml --chart tracks").status, 2);
  EXPECT_EQ(run("$GLIDERCC sim f.toml --picture p.svg --chart speed").status, 2);
  EXPECT_EQ(run("$GLIDERCC sim up.mission --picture p.svg --chart tracks").status, 2);
  const Outcome alone = run("$GLIDERCC sim f.toml --only a -o f --picture p.svg --chart distances");
  EXPECT_EQ(alone.status, 2);
  EXPECT_THAT(alone.err, HasSubstr("no two vehicles flew at the same time"));
}

/// As a mission it would have 19 errors.
TEST_F(FleetCommand, OtherCommandsSayThatAFleetIsNoMission) {
  mission("up", "39.26");
  (void)folder_.write("f.toml", vehicle("a", "up"));
  for (const char* command :
       {"build f.toml", "brief f.toml", "graph f.toml", "check f.toml up.mission"}) {
    const Outcome refused = run("$GLIDERCC " + std::string(command));
    EXPECT_EQ(refused.status, 2) << command;
    EXPECT_THAT(refused.err, HasSubstr("`f.toml` is a fleet or another file of settings"))
        << command;
    EXPECT_THAT(refused.err, Not(HasSubstr("f.toml:1"))) << command;
  }
}

/// Of different kinds, in one sea.
TEST_F(FleetCommand, GlidersAndVehiclesWithAPropellerFlyTogether) {
  mission("up", "39.18");
  std::string text = slurped("up.mission");
  text.replace(text.find("yo(5 m, bottom)"), 15, "yo(5 m, 15 m)");
  for (const char* kind : {"lauv", "remus100"}) {
    std::string of_kind = text;
    of_kind.insert(of_kind.find('\n'), std::string("\nplatform ") + kind);
    (void)folder_.write(std::string(kind) + ".mission", of_kind);
  }
  (void)folder_.write(
      "f.toml", vehicle("g", "up") + vehicle("l", "lauv", "bearing_deg = 90\ndistance_m = 3000\n") +
                    vehicle("r", "remus100", "bearing_deg = 0\ndistance_m = 3000\n"));
  const Outcome flown = run("$GLIDERCC sim --format json f.toml -o f");
  EXPECT_THAT(flown.err, Not(HasSubstr("error")));
  const auto document = nlohmann::json::parse(flown.out);
  EXPECT_EQ(document["vehicles"][1]["platform"], "lauv");
  EXPECT_EQ(document["vehicles"][2]["platform"], "remus100");
  for (const auto& one : document["vehicles"]) {
    EXPECT_LT(one["figures"]["apart"], 500) << "its own positions are from its own start";
    EXPECT_GT(one["figures"]["distance"], 100);
  }
}

}  // namespace
}  // namespace glider::tests
