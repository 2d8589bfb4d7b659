// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// glidercc check --report: what a mission needs of boards and lines.

#include "tests/support/command.h"
#include "tests/support/replaced.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <gmock/gmock.h>

namespace glider::tests {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

const std::string kReported = GLIDER_SOURCE_DIR "/missions/figure2.mission";

// accepts: GL4013, GL4014
TEST(CheckReport, TheGalleryHasABoundForEveryQuantityAndFits) {
  const Outcome outcome =
      runShell("$GLIDERCC check --report --format json " GLIDER_SOURCE_DIR
               "/missions/*.mission " GLIDER_SOURCE_DIR "/missions/gallery/*.mission");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  const json document = json::parse(outcome.out);
  EXPECT_GT(document["missions"].size(), 10u);
  for (const json& mission : document["missions"]) {
    EXPECT_EQ(mission["budget"].size(), 5u) << mission["file"];
    for (const auto& [of, budget] : mission["budget"].items()) {
      for (const auto& [name, quantity] : budget.items()) {
        ASSERT_TRUE(quantity["value"].is_number()) << mission["file"] << of << quantity;
        EXPECT_GT(quantity["value"], 0) << name;
        if (quantity.contains("limit")) {
          EXPECT_LE(quantity["value"], quantity["limit"]) << mission["file"] << of << name;
        }
      }
    }
  }
}

/// From eight cases on their guards are evaluated by a table, which calls other functions through
/// pointers.
TEST(CheckReport, TheStackHasABoundForAnyNumberOfCases) {
  const TemporaryFolder folder;
  for (const char* vehicle : {"slocum", "lauv", "remus100"}) {
    for (const int cases : {1, 7, 8, 30}) {
      std::string text =
          std::string("mission m\nplatform ") + vehicle +
          "\nvar x: number = 0\nstate s\nbegin\n  flightroute nav(39.18 N 73.83 W)\n"
          "  flightprofile yo(5 m, 20 m)\n  sensors missiontime, depth, temp\n  events\n";
      for (int i = 0; i < cases; ++i) {
        text += "    case temp > " + std::to_string(i) + " degC && depth > " + std::to_string(i) +
                " m do set x = " + std::to_string(i) + " end stay\n";
      }
      text += "    case missiontime >= 30 min exit\nend\n";
      (void)folder.write("m.mission", text);
      const Outcome outcome =
          runShell("cd " + folder.path().string() + " && $GLIDERCC check --report m.mission");
      EXPECT_THAT(outcome.out, testing::ContainsRegex("  stack +[0-9,]+ of")) << vehicle << cases;
      EXPECT_THAT(outcome.out, testing::Not(testing::ContainsRegex("stack +no bound is known")))
          << vehicle << cases;
    }
  }
}

TEST(CheckReport, SaysWhereTheSbcSleepsAndWhatKeepsItAwake) {
  const TemporaryFolder folder;
  (void)folder.write("m.mission", R"(mission m
nap at most 4 min

state dive
begin
  flightroute   heading(90 deg)
  flightprofile yo(5 m, 25 m)
  sensors       missiontime, depth, temp
  events
    case temp < 8 degC goto track
    case missiontime >= 3 h exit
end

state track
begin
  flightroute   noheading
  flightprofile thermotrackyo(5 m, 25 m, 26 deg, 26 deg, 2 degC, 3 m)
  sensors       missiontime, depth, temp
  events
    case statetime >= 1 h goto dive
end
)");
  const Outcome outcome =
      runShell("cd " + folder.path().string() + " && $GLIDERCC check --report m.mission");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  const std::string all = outcome.out + outcome.err;
  EXPECT_THAT(all, testing::HasSubstr(
                       "in `dive` the SBC may sleep until woken by `depth`, `temp` and time\n"));
  EXPECT_THAT(all, testing::HasSubstr("in `track` the SBC stays awake: "));
  EXPECT_THAT(all, testing::HasSubstr("standard.mission:"));
  EXPECT_THAT(all, testing::Not(testing::ContainsRegex("stack +no bound is known")));
}

/// What is known otherwise may say why a requirement does not hold.
TEST(CheckReport, SaysWhatIsKnownOfAMissionThatViolatesARequirement) {
  const TemporaryFolder folder;
  (void)folder.write("m.mission", R"(mission m
require always depth <= 10 m

state look
begin
  flightprofile yo(5 m, 20 m)
  sensors       missiontime, depth
  events
    case missiontime >= 3 h exit
end
)");
  const std::string check = "cd " + folder.path().string() + " && $GLIDERCC check m.mission";
  const Outcome reported = runShell(check + " --report");
  EXPECT_EQ(reported.status, 1);
  EXPECT_THAT(reported.out, HasSubstr("by the vehicle's power table the mission takes at most"));
  EXPECT_THAT(reported.out, HasSubstr("the mission ends after at most 3 h"));
  EXPECT_EQ(runShell(check).out, "");
}

TEST(CheckReport, IsATableForPeople) {
  const Outcome outcome = runShell("$GLIDERCC check --report --target ts7800 " + kReported);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, testing::ContainsRegex("to payload +[0-9]+ of 46,080 bytes a cycle"));
  EXPECT_THAT(outcome.out, testing::ContainsRegex("executable +[0-9,]+ of 131,072 bytes"));
  EXPECT_THAT(outcome.out, testing::ContainsRegex("  stack +[0-9,]+ of 65,536 bytes"));
  EXPECT_THAT(outcome.out, testing::ContainsRegex("tick instructions +[0-9,]+ of 12,500,000"));
  EXPECT_THAT(outcome.out, testing::Not(HasSubstr("ts5500")));
  EXPECT_THAT(outcome.out, HasSubstr("figure2.mission: fine"));
}

/// What a vehicle does that does not obey follows from that.
TEST(CheckReport, NamesARefusedCommandAlone) {
  const TemporaryFolder folder;
  const auto refused = folder.write("refused.mission",
                                    "mission refused\nrequire always depth <= 30 m\n"
                                    "state a begin\n  flightprofile yo(5 m, 4000 m)\n"
                                    "  sensors missiontime\n  events\n"
                                    "    case missiontime > 1 h exit\nend\n");
  const Outcome outcome = runShell("$GLIDERCC check " + refused.string());
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.err, HasSubstr("[GL3104 "));
  EXPECT_THAT(outcome.err, Not(HasSubstr("[GL311")));
}

// The lines of docs/verification.md.
TEST(CheckReport, SaysTheWayHome) {
  const Outcome outcome = runShell("$GLIDERCC check --report --target host " + kReported);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out,
              HasSubstr("\nthe mission ends after at most 42 min 0 s; with "
                        "power cuts of the SBC of up to 5 min 0 s, after at most 46 min 40 s\n"));
  EXPECT_THAT(
      outcome.out,
      HasSubstr("\nif the SBC stops responding, hookbeh revokes control within 72 s (assuming "
                "silence_secs 24; see --mi); from at most 25 m deep, "
                "the vehicle is at the surface within 11 min 32 s\n"));
}

/// What the mission takes from the batteries, and why it may be much.
TEST(CheckReport, SaysHowMuchEnergyItTakesAtMost) {
  const auto linesOf = [](const std::string& mission) {
    return runShell("$GLIDERCC check --report --target host " GLIDER_SOURCE_DIR "/missions/" +
                    mission)
        .out;
  };
  EXPECT_THAT(linesOf("gallery/low_battery.mission"),
              HasSubstr("\nby the vehicle's power table the mission takes at most 73.1 Wh until it "
                        "ends, 3.3 % of the 2,222 Wh that the pack gives: pump 37 %, SBC 28 %"));
  EXPECT_THAT(linesOf("gallery/thermocline.mission"),
              HasSubstr("\nthe pump may hardly rest in `track`: "));
  const TemporaryFolder folder;
  const auto deep = folder.write(
      "deep.mission",
      "mission deep\npack 168 Ah at 14.4 V reserve 25 %\nstate down\nbegin\n  flightprofile yo(5 "
      "m, "
      "80 m)\n  sensors missiontime, depth\n  events\n    case missiontime > 1 h exit\nend\n");
  const std::string said = runShell("$GLIDERCC check --report --target host " + deep.string()).out;
  EXPECT_THAT(said,
              HasSubstr(" of the 2,027 Wh that the pack gives (168 Ah at 12.1 V on average, as "
                        "the voltage falls from 14.4 V to 10 V; the reserve is a part of it): "));
  EXPECT_THAT(said,
              HasSubstr("`down` may command a depth of 80 m: with the mission files that come with "
                        "glidercc, hookbeh refuses more than 60 m (max_depth in skeleton.mi)"));
  const std::string cold =
      "  flightprofile yo(5 m, 50 m)\n  sensors temp, depth\n  events\n    case temp ";
  const auto soon =
      folder.write("soon.mission", "mission soon\nassume no outage\nstate warm\nbegin\n" + cold +
                                       "< 10 degC goto cold\nend\nstate cold\nbegin\n" + cold +
                                       "> 10 degC goto warm\nend\n");
  EXPECT_THAT(runShell("$GLIDERCC check --report --target host " + soon.string()).out,
              HasSubstr("\nit takes so much if `warm` and `cold` follow one another again and "
                        "again, one round every 8 s: a minimum time in one of them lowers the "
                        "bound\n"));
  const auto endless =
      folder.write("endless.mission",
                   "mission endless\npack 100 Ah at 14.4 V reserve 10 %\nstate fly\nbegin\n"
                   "  flightprofile yo(5 m, 50 m, 26 deg, 26 deg)\n  sensors temp, depth, charge\n"
                   "  events\n    case temp > 30 degC exit\nend\n");
  EXPECT_THAT(
      runShell("$GLIDERCC check --report --target host " + endless.string()).out,
      testing::ContainsRegex("the mission takes at most 1[01]\\.[0-9] W on average in a long "
                             "flight, so a pack that gives "
                             "1,2[0-9][0-9] Wh [(]100 Ah at 12.1 V on average.*[)] lasts at "
                             "least 4\\.[4-9] days: "));
  const auto lauv = folder.write("lauv.mission",
                                 "mission lauv\nplatform lauv\nstate fly\nbegin\n"
                                 "  flightprofile surfaced\n  sensors missiontime\n"
                                 "  events\n    case missiontime > 1 h exit\nend\n");
  const Outcome none = runShell("$GLIDERCC check --report --target host " + lauv.string());
  EXPECT_EQ(none.status, 0) << none.err;
  EXPECT_THAT(none.out, Not(HasSubstr("power table")));
}

TEST(CheckReport, TakesTheSilenceFromTheVehiclesMissionFile) {
  const TemporaryFolder folder;
  const auto skeleton = folder.write("patient.mi",
                                     "behavior: surface\n    b_arg: start_when(enum) 1\n"
                                     "behavior: hookbeh\n    b_arg: silence_secs(s) 300\n");
  const Outcome outcome = runShell("$GLIDERCC check --report --target host --skeleton " +
                                   skeleton.string() + " " + kReported);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(
      outcome.out,
      HasSubstr("hookbeh revokes control within 348 s (silence_secs 300 from patient.mi); from at "
                "most 25 m deep, the vehicle is at the surface within 16 min 8 s\n"));
}

TEST(CheckReport, RefusesAMissionFileThatSaysNoSilence) {
  const TemporaryFolder folder;
  const auto refusal = [&](const std::string& text) {
    const Outcome outcome = runShell("$GLIDERCC check --report --target host --skeleton " +
                                     folder.write("a.mi", text).string() + " " + kReported);
    EXPECT_EQ(outcome.status, 2) << outcome.out;
    return outcome.err;
  };
  EXPECT_THAT(refusal("behavior: surface\n"), HasSubstr("no behavior `hookbeh`"));
  EXPECT_THAT(refusal("behavior: hookbeh\n    b_arg: silence_secs(s) -5\n"),
              HasSubstr("silence_secs must be above 0 and at most 600, not -5"));
  EXPECT_THAT(refusal("behaviour hookbeh\n"), HasSubstr("GL51"));
  EXPECT_THAT(runShell("$GLIDERCC check --report --target host --skeleton " +
                       (folder.path() / "none.mi").string() + " " + kReported)
                  .err,
              HasSubstr("GL9001"));
}

// `upper` and `lower` have no range; they are only ever set between 5 m and 28 m.
TEST(CheckReport, TheWayHomeKnowsWhereVariablesAreEverSetTo) {
  const Outcome outcome = runShell("$GLIDERCC check --report --target host " GLIDER_SOURCE_DIR
                                   "/missions/gallery/thermocline.mission");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out,
              HasSubstr("from at most 33 m deep, the vehicle is at the surface within 14 min "
                        "12 s\n"));
}

TEST(CheckReport, SaysThatNoBoundIsKnownOfADepthThatMayBeAnything) {
  const TemporaryFolder folder;
  const auto mission = folder.write("m.mission",
                                    "mission m\nvar deep : length = 10 m\n"
                                    "state first\nbegin\n  flightprofile yo(3 m, deep, 0.4, 0.4)\n"
                                    "  sensors depth, missiontime\n  events\n"
                                    "    case depth > 9 m do set deep = deep + 1 m end stay\n"
                                    "    case missiontime > 1 h exit\nend\n");
  const Outcome outcome = runShell("$GLIDERCC check --report --target host " + mission.string());
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("no bound on the vehicle's depth is known\n"));
}

TEST(CheckReport, SaysWhereTheWayHomeIsShorter) {
  const TemporaryFolder folder;
  const auto mission = folder.write("m.mission",
                                    "mission m\n"
                                    "state first\nbegin\n  flightprofile yo(3 m, 10 m, 0.4, 0.4)\n"
                                    "  events\n    case missiontime > 1 h goto deep\nend\n"
                                    "state deep\nbegin\n  flightprofile yo(3 m, 30 m, 0.4, 0.4)\n"
                                    "  events\n    case missiontime > 2 h goto up\nend\n"
                                    "state up\nbegin\n  flightprofile surfaced\n"
                                    "  events\n    case missiontime > 3 h exit\nend\n");
  const Outcome outcome = runShell("$GLIDERCC check --report --target host " + mission.string());
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out,
              HasSubstr("from at most 35 m deep, the vehicle is at the surface within 14 min"));
  EXPECT_THAT(outcome.out, HasSubstr("\n  in `first`: from at most 15 m, within 8 min 12 s\n"));
  EXPECT_THAT(outcome.out, testing::Not(HasSubstr("  in `up`"))) << "it comes there from `deep`";
}

TEST(CheckReport, TheHostHasNoBoundOfInstructions) {
  const Outcome outcome = runShell("$GLIDERCC check --report --target host " + kReported);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("no bound is known"));
}

TEST(CheckReport, TheHostHasNoBoundOfTheStack) {
  const Outcome outcome =
      runShell("$GLIDERCC check --report --format json --target host " + kReported);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  const json stack = json::parse(outcome.out)["missions"][0]["budget"]["host"]["stack"];
  EXPECT_TRUE(stack["value"].is_null());
  EXPECT_THAT(stack["remark"], HasSubstr("cannot be analysed"));
}

TEST(CheckReport, AnUnknownTargetIsAUsageError) {
  const Outcome outcome = runShell("$GLIDERCC check --report --target ts1 " + kReported);
  EXPECT_EQ(outcome.status, 2);
  EXPECT_THAT(outcome.err, HasSubstr("GL4001"));
}

TEST(CheckReport, TooMuchForABoardIsAnError) {
  const TemporaryFolder folder;
  std::string text =
      "mission heavy\nstate s\nbegin\n  flightprofile surfaced\n"
      "  sensors missiontime, temp, depth\n  events\n";
  for (int i = 0; i < 24; ++i) {
    text += "    case mean(temp, " + std::to_string(1000 + i) + " s) > 25 degC exit\n";
  }
  text += "    case missiontime > 1 h exit\nend\n";
  const std::string mission = folder.write("heavy.mission", text).string();
  const Outcome outcome = runShell("$GLIDERCC check --report --target ts7800 " + mission);
  EXPECT_EQ(outcome.status, 1) << outcome.out;
  EXPECT_THAT(outcome.err, HasSubstr("[GL4013 board-overloaded]"));
  EXPECT_THAT(outcome.err, HasSubstr("instructions a tick"));
  EXPECT_THAT(outcome.err,
              HasSubstr("shorter or fewer windows (the longest is `mean(temp, 1021 s)`, line 28)"));
  EXPECT_THAT(outcome.out, HasSubstr("tick instructions")) << "the table is still shown";
  EXPECT_EQ(runShell("$GLIDERCC check " + mission).status, 0) << "not asked for";
  const std::string out = (folder.path() / "out").string();
  for (const char* way : {"", "--dialect extctl "}) {
    const Outcome built =
        runShell(std::string("$GLIDERCC build --target ts7800 ") + way + mission + " -o " + out);
    EXPECT_EQ(built.status, 1) << way;
    EXPECT_THAT(built.err, HasSubstr("[GL4013 board-overloaded]")) << way;
    EXPECT_FALSE(fs::exists(out)) << way;
  }
  EXPECT_EQ(runShell("$GLIDERCC build --target ts7800 --ignore-limits " + mission + " -o " + out +
                     "-nevertheless")
                .status,
            0);
  EXPECT_EQ(runShell("$GLIDERCC build --target host " + mission + " -o " + out + "-host").status, 0)
      << "it has no limit";
}

/// No window over a leg copies what it keeps of one: on some boards that would be a loop.
TEST(CheckReport, WindowsOverLegsHaveABoundOnEachBoard) {
  const TemporaryFolder folder;
  for (const char* window :
       {"mean(temp, last leg) > 25 degC", "depth_of_highest(temp, this dive) > 5 m",
        "steepest(temp, last dive) > 1 degC/m", "depth_of_steepest(temp, this leg) > 5 m"}) {
    std::string text =
        "mission legs\nstate s\nbegin\n  flightprofile yo(5 m, 20 m, 26 deg, 26 deg)\n"
        "  sensors missiontime, temp, depth, m_depth_state\n  events\n    case ";
    text += window;
    text += " exit\n    case missiontime > 1 h exit\nend\n";
    const std::string mission = folder.write("legs.mission", text).string();
    const Outcome outcome = runShell("$GLIDERCC check --report " + mission);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_THAT(outcome.out, testing::ContainsRegex("tick instructions +[0-9,]+ of 3,300,000"));
    EXPECT_THAT(outcome.out,
                testing::ContainsRegex("tick instructions +[0-9],[0-9,]+ of 12,500,000"));
  }
}

TEST(CheckReport, OfAMissionWithCodeInCItNeedsTheCode) {
  const std::string mission = GLIDER_SOURCE_DIR "/missions/examples/sensor/optode.mission";
  const Outcome without = runShell("$GLIDERCC check --report --target ts7800 " + mission);
  EXPECT_EQ(without.status, 0) << without.err;
  EXPECT_THAT(without.out, HasSubstr("optode_o2"));
  EXPECT_THAT(without.out, HasSubstr("--link FILE"));
  EXPECT_THAT(without.out, HasSubstr("if the SBC stops responding")) << "the rest is said";
  const TemporaryFolder folder;
  const std::string object = (folder.path() / "optode.o").string();
  const Outcome built = runShell(
      "cd " + folder.path().string() + " && $GLIDERCC build " + mission +
      " --emit header -o optode.h && clang-19 $($GLIDERCC targets --cflags ts7800) -I. -c " +
      GLIDER_SOURCE_DIR "/missions/examples/sensor/optode.c -o optode.o");
  ASSERT_EQ(built.status, 0) << built.err;
  const Outcome with =
      runShell("$GLIDERCC check --report --target ts7800 --link " + object + " " + mission);
  EXPECT_EQ(with.status, 0) << with.err;
  EXPECT_THAT(with.out, HasSubstr("of 131,072 bytes"));
}

const fs::path kShare = GLIDER_BINARY_DIR "/share/glidercc";

/// In `to` links to all that `from` holds but `name`, which becomes an empty folder.
void linkAllBut(const fs::path& from, const std::string& name, const fs::path& to) {
  fs::create_directory(to);
  for (const auto& entry : fs::directory_iterator(from)) {
    if (entry.path().filename() != name) {
      fs::create_symlink(entry.path(), to / entry.path().filename());
    }
  }
  fs::create_directory(to / name);
}

/// With soft floats and what a copy of a table would cost, they had no bound, or a hundred times
/// this.
TEST(CheckReport, WhatIsComputedOfSeawaterFitsOnEachBoard) {
  const TemporaryFolder folder;
  const std::string mission = folder
                                  .write("water.mission", R"(mission water
state s
begin
  flightprofile yo(5 m, 20 m)
  sensors       missiontime, depth, temp, cond, scipressure
  events
    case missiontime > 1 h exit
    case became(depth > 10 m) do
      log "water", salinity, density, mean(salinity, 5 min)
    end stay
end
)")
                                  .string();
  const Outcome outcome = runShell("$GLIDERCC check --report " + mission);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, testing::Not(HasSubstr("no bound is known")));
}

TEST(CheckReport, TooMuchStackForABoardIsAnError) {
  const TemporaryFolder folder;  // a board with little of it
  const fs::path share = folder.path() / "share", boards = share / "boards";
  linkAllBut(kShare, "boards", share);
  fs::remove(boards);
  linkAllBut(kShare / "boards", "ts5500", boards);
  fs::remove(boards / "ts5500");
  linkAllBut(kShare / "boards/ts5500", "board.toml", boards / "ts5500");
  fs::remove(boards / "ts5500/board.toml");
  (void)folder.write("share/boards/ts5500/board.toml",
                     replaced(slurp(kShare / "boards/ts5500/board.toml"), "max_stack_bytes = 65536",
                              "max_stack_bytes = 1024"));
  const Outcome outcome = runShell("GLIDERCC_SHARE=" + share.string() +
                                   " $GLIDERCC check --report --target ts5500 " + kReported);
  EXPECT_EQ(outcome.status, 1) << outcome.out << outcome.err;
  EXPECT_THAT(outcome.err, testing::ContainsRegex("needs up to [0-9]+ bytes of stack on board "
                                                  "`ts5500`, but 1024 .*GL4013"));
  EXPECT_THAT(outcome.out, testing::ContainsRegex("stack +[0-9,]+ of 1,024 bytes"));
}

TEST(CheckReport, TooMuchForALineIsAnError) {
  const TemporaryFolder folder;  // a vehicle whose cycle is short, and its lag
  const fs::path share = folder.path() / "share";
  linkAllBut(kShare, "platforms", share);
  (void)folder.write(
      "share/platforms/slocum.toml",
      replaced(replaced(slurp(kShare / "platforms/slocum.toml"), "cycle_s = 4.0", "cycle_s = 0.05"),
               "line_lag_s = 8.0", "line_lag_s = 0.1"));
  const Outcome outcome =
      runShell("GLIDERCC_SHARE=" + share.string() + " $GLIDERCC check --report " + kReported);
  EXPECT_EQ(outcome.status, 1) << outcome.out;
  EXPECT_THAT(outcome.err, HasSubstr("[GL4014 line-overloaded]"));
  EXPECT_THAT(outcome.err, HasSubstr("115200 baud"));
}

}  // namespace
}  // namespace glider::tests
