// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The compiled missions under faults of every kind, by `glidercc campaign`; scripts/soak/faults
// flies more of the same.

#include "tests/flights/flight.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <gmock/gmock.h>
#include <sstream>

namespace glider::tests {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

const std::string kMissions =
    project("missions/figure2.mission") + " " + project("missions/gallery/thermocline.mission");

TEST(Campaign, EveryKindOfFaultEndsAsStated) {
  const TemporaryFolder folder;
  const std::string csv = (folder.path() / "flights.csv").string();
  const Outcome outcome = runShell("$GLIDERCC campaign " + kMissions +
                                   " --flights 192 --boards 5 --seed 1 --csv " + csv);
  EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("SBC power cut"));
  EXPECT_THAT(outcome.out, HasSubstr("192 flights, seed 1"));
  const std::string rows = slurp(csv);
  EXPECT_EQ(std::ranges::count(rows, '\n'), 2 + 192);
  EXPECT_THAT(rows, HasSubstr("exited after release"));
  EXPECT_THAT(rows, HasSubstr(",released,"));
}

/// What few missions use is checked as what all use: instruments, and an SBC that sleeps.
TEST(Campaign, MissionsThatSampleAndThatSleepKeepEveryPromise) {
  const TemporaryFolder folder;
  const std::string samples = folder.write("samples.mission", R"(mission samples
state look
begin
  flightprofile yo(5 m, 20 m)
  sensors       missiontime, depth
  sample        ctd every 20 s below 10 m, fluorometer off
  events
    case missiontime > 40 min exit
end
)");
  const std::string sleeps = folder.write("sleeps.mission", R"(mission sleeps
nap at most 4 min
state down
begin
  flightroute   heading(90 deg)
  flightprofile yo(5 m, 50 m)
  sensors       missiontime, depth, temp
  events
    case statetime > 20 min goto hold
end

state hold
begin
  flightroute   noheading
  flightprofile hover_at(15 m)
  sensors       missiontime, depth, temp
  events
    case statetime > 30 min exit
end
)");
  const Outcome outcome = runShell("$GLIDERCC campaign " + samples + " " + sleeps +
                                   " --flights 156 --boards 0 --seed 1");
  EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  EXPECT_THAT(outcome.out, ContainsRegex("\nnone +4 +4 +0 +0 +[0-9.]+ +0\n"));
}

TEST(Campaign, SaysNothingOfAFaultThatWasNotFlown) {
  const Outcome outcome = runShell("$GLIDERCC campaign " + project("missions/figure2.mission") +
                                   " --flights 1 --boards 0 --seed 1");
  EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  EXPECT_THAT(outcome.out, ContainsRegex("\nnone +1 +1 +0 +0 +2[0-9]\\.[0-9] +0\n"));
  EXPECT_THAT(outcome.out, Not(HasSubstr("several at once")));
}

TEST(Campaign, FliesTheKindsOfFaultsThatAreAskedFor) {
  const std::string asked = "$GLIDERCC campaign " + project("missions/figure2.mission") +
                            " --boards 0 --fault 'sensor stuck' --fault 'line cut'";
  const Outcome outcome = runShell(asked + " --flights 8 --seed 1");
  EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  EXPECT_THAT(outcome.out, ContainsRegex("\nline cut +4 "));
  EXPECT_THAT(outcome.out, ContainsRegex("\nsensor stuck +4 "));
  EXPECT_THAT(outcome.out, Not(HasSubstr("none")));
  EXPECT_THAT(runShell(asked + " --only 3").out, HasSubstr("sensor stuck"));
  const Outcome unknown = runShell("$GLIDERCC campaign m.mission --fault gremlins");
  EXPECT_EQ(unknown.status, 2);
  EXPECT_THAT(unknown.err, HasSubstr("gremlins"));
}

TEST(Campaign, IsTheSeedsAloneHoweverManyFlyAtATime) {
  const TemporaryFolder folder;
  const auto csv = [&](const std::string& jobs, const std::string& seed) {
    const std::string file = (folder.path() / ("jobs" + jobs + seed)).string();
    const Outcome outcome = runShell("$GLIDERCC campaign " + kMissions +
                                     " --scenario figure5 --boards 0 --flights 42 --jobs " + jobs +
                                     " --seed " + seed + " --csv " + file);
    EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
    return slurp(file);
  };
  const std::string alone = csv("1", "3");
  EXPECT_EQ(alone, csv("3", "3"));
  EXPECT_NE(alone, csv("2", "4"));
}

TEST(Campaign, FliesOneAgainAndItsFaultsAreAScenarios) {
  const TemporaryFolder folder;
  const std::string out = (folder.path() / "one").string();
  const std::string mission = project("missions/figure2.mission");
  const Outcome outcome =
      runShell("$GLIDERCC campaign " + mission + " --boards 0 --only 13 -o " + out);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("SBC power cut"));
  EXPECT_THAT(slurp(out + "/events.csv"), HasSubstr("the SBC is gone"));
  const size_t begin = outcome.out.find("[[faults."),
               end = outcome.out.rfind('\n', outcome.out.size() - 2);
  const size_t seed = outcome.out.find("--seed");
  ASSERT_NE(begin, std::string::npos) << outcome.out;
  std::filesystem::copy(project("scenarios/skeleton.mi"), folder.path());
  const auto scenario =
      folder.write("again.toml", slurp(project("scenarios/default.toml")) +
                                     outcome.out.substr(begin, end - begin) + "\n");
  const Outcome again =
      runShell("$GLIDERCC sim " + mission + " --scenario " + scenario.string() + " " +
               outcome.out.substr(seed, begin - seed - 1) + " -o " + out + "2");
  EXPECT_NE(again.status, 2) << again.err << again.out;
  EXPECT_EQ(slurp(out + "/trace.csv"), slurp(out + "2/trace.csv"));
}

TEST(Campaign, AsManyFlyAtATimeAsIsAsked) {
  // Threads of the program, the one that waits for them with it; the most of a few looks.
  const Outcome outcome =
      runShell("$GLIDERCC campaign " + kMissions +
               " --boards 0 --flights 5000 --jobs 3 > /dev/null & n=0; most=0; "
               "while [ $n -lt 600 ] && [ $most -lt 4 ]; do t=$(ls /proc/$!/task | wc -l); "
               "[ $t -gt $most ] && most=$t; sleep 0.05; n=$((n+1)); done; kill -INT $!; wait $!; "
               "echo $most");
  EXPECT_EQ(outcome.out, "4\n") << outcome.err;
}

// accepts: GL9373
TEST(Campaign, ResumesNothingWhoseImportsOrArgumentFilesAreOthers) {
  const TemporaryFolder folder;
  const auto write = [&](const std::string& top, const std::string& wait_s) {
    (void)folder.write("depths.mission", "const top : length = " + top + "\n");
    (void)folder.write("surfac07.ma",
                       "behavior_name=surface\n<start:b_arg>\n    b_arg: gps_wait_time(s) " +
                           wait_s + "\n<end:b_arg>\n");
  };
  (void)folder.write("m.mission",
                     "mission m\nimport \"depths\"\nstate s\nbegin\n  flightprofile yo(top, 20 m, "
                     "26 deg, 26 deg)\n  sensors missiontime\n  events\n    case missiontime >= 5 "
                     "min exit\nend\n");
  std::string skeleton = slurp(project("scenarios/skeleton.mi"));
  const size_t at = skeleton.find("behavior: surface");
  ASSERT_NE(at, std::string::npos);
  skeleton.insert(skeleton.find('\n', at) + 1, "    b_arg: args_from_file(enum) 7\n");
  (void)folder.write("skeleton.mi", skeleton);
  (void)folder.write("world.toml", slurp(project("scenarios/default.toml")));
  const std::string command = "cd " + folder.path().string() +
                              "; $GLIDERCC campaign m.mission --scenario world.toml --boards 0 "
                              "--flights 2 ";
  write("5 m", "0");
  const Outcome first = runShell(command + "--csv flights.csv");
  ASSERT_EQ(first.status, 0) << first.err;
  EXPECT_EQ(runShell(command + "--resume flights.csv").status, 0);
  write("6 m", "0");
  EXPECT_THAT(runShell(command + "--resume flights.csv").err, HasSubstr("another campaign"));
  write("5 m", "1");
  EXPECT_THAT(runShell(command + "--resume flights.csv").err, HasSubstr("another campaign"));
}

/// The rows of a campaign's file of flights, in the order of the file.
std::vector<std::string> rowsOf(const std::string& file) {
  std::istringstream text(slurp(file));
  std::vector<std::string> rows;
  for (std::string row; std::getline(text, row);) {
    rows.push_back(row);
  }
  return rows;
}

/// The table without the time that it took.
std::string tableOf(const Outcome& outcome) {
  return outcome.out.substr(0, outcome.out.rfind(", "));
}

class CampaignResumed : public testing::TestWithParam<const char*> {};

TEST_P(CampaignResumed, GoesOnAfterASignalAsIfThereHadBeenNone) {
  const TemporaryFolder folder;
  const std::string whole = (folder.path() / "whole.csv").string();
  const std::string cut = (folder.path() / "cut.csv").string();
  const std::string command =
      "$GLIDERCC campaign " + kMissions + " --boards 0 --jobs 1 --flights 100 --seed 7 ";
  const Outcome uninterrupted = runShell(command + "--csv " + whole);
  ASSERT_EQ(uninterrupted.status, 0) << uninterrupted.out << uninterrupted.err;
  // The signal comes when a few flights are on the disk: a busy machine changes nothing.
  const std::string kill =
      "n=0; while [ $n -lt 600 ] && [ $(wc -l < " + cut +
      " 2>/dev/null || echo 0) -lt 12 ]; do sleep 0.05; n=$((n+1)); done; kill -" + GetParam() +
      " $!; wait $!";
  const Outcome killed = runShell(command + "--csv " + cut + " & " + kill);
  EXPECT_GT(killed.status, 128) << killed.out;
  const auto before = rowsOf(cut);
  ASSERT_GE(before.size(), 12U);
  ASSERT_LT(before.size(), 102U) << "it was over before the signal";
  if (std::string(GetParam()) == "INT") {
    EXPECT_EQ(killed.status, 130);
    EXPECT_THAT(killed.out, HasSubstr("interrupted after"));
    EXPECT_THAT(killed.out, HasSubstr("\nall "));
    EXPECT_THAT(killed.out, HasSubstr("--resume " + cut));
  }
  // A row that was torn in the middle is flown again. accepts: GL9373
  const std::string text = slurp(cut);
  std::ofstream(cut) << text.substr(0, text.size() - 7);
  const Outcome resumed = runShell(command + "--resume " + cut);
  EXPECT_EQ(resumed.status, 0) << resumed.out << resumed.err;
  EXPECT_EQ(slurp(cut), slurp(whole));
  EXPECT_EQ(tableOf(resumed), tableOf(uninterrupted));
}

INSTANTIATE_TEST_SUITE_P(, CampaignResumed, testing::Values("INT", "KILL"));

TEST(Campaign, ResumesNothingThatIsNotItsOwn) {
  const TemporaryFolder folder;
  const std::string csv = (folder.path() / "flights.csv").string();
  const std::string command = "$GLIDERCC campaign " + kMissions + " --boards 0 --flights 4 ";
  ASSERT_EQ(runShell(command + "--csv " + csv).status, 0);
  const std::string good = slurp(csv);
  const auto refused = [&](const std::string& options, const std::string& why) {
    const Outcome outcome = runShell("$GLIDERCC campaign " + options + " --resume " + csv);
    EXPECT_EQ(outcome.status, 2) << outcome.out;
    EXPECT_THAT(outcome.err, HasSubstr("GL9373"));
    EXPECT_THAT(outcome.err, HasSubstr(why));
  };
  refused(kMissions + " --boards 0 --flights 5", "another campaign");
  refused(kMissions + " --boards 0 --flights 4 --seed 2", "another campaign");
  refused(kMissions + " --boards 0 --flights 4 --scenario figure5", "another campaign");
  refused(project("missions/figure2.mission") + " --boards 0 --flights 4", "another campaign");
  std::ofstream(csv) << good << "3,what,is this\n";
  refused(kMissions + " --boards 0 --flights 4", "line 7 is not a flight");
  std::ofstream(csv) << "flight,mission\n";
  refused(kMissions + " --boards 0 --flights 4", "not the CSV file of a campaign");
  std::filesystem::remove(csv);
  EXPECT_EQ(runShell(command + "--resume " + csv).status, 2);
  EXPECT_EQ(runShell(command + "--resume x --csv y").status, 2);
}

TEST(Campaign, AShareOfTheFlightsRunsBoardBinariesWithTheSameOutcome) {
  const TemporaryFolder folder;
  const auto rows = [&](const std::string& percent) {
    const std::string file = (folder.path() / percent).string();
    const Outcome outcome =
        runShell("$GLIDERCC campaign " + project("missions/figure2.mission") +
                 " --flights 16 --seed 5 --boards " + percent + " --csv " + file);
    EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
    return rowsOf(file);
  };
  const auto boards = rows("100");
  ASSERT_EQ(boards.size(), 18U);
  size_t ts7800 = 0, ts5500 = 0, pizero2 = 0, cm4 = 0;
  for (const std::string& row : boards) {
    ts7800 += row.find(",ts7800,") != std::string::npos ? 1U : 0U;
    ts5500 += row.find(",ts5500,") != std::string::npos ? 1U : 0U;
    pizero2 += row.find(",pizero2,") != std::string::npos ? 1U : 0U;
    cm4 += row.find(",cm4,") != std::string::npos ? 1U : 0U;
  }
  EXPECT_EQ(ts7800 + ts5500 + pizero2 + cm4, 16U);
  EXPECT_GT(pizero2, 0U);
  EXPECT_GT(cm4, 0U);
  EXPECT_GT(ts7800, 0U);
  EXPECT_GT(ts5500, 0U);
}

TEST(Campaign, WithoutAnEmulatorEverythingFliesInProcessAndThatIsReported) {
  const Outcome outcome =
      runShell("PATH=/nowhere $GLIDERCC campaign " + project("missions/figure2.mission") +
               " --flights 3 --boards 100");
  EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("those flights run in this process"));
  EXPECT_THAT(outcome.out, HasSubstr("in process"));
}

/// A campaign of `flights` flights in the scenario `default` with `faults` put behind it.
Outcome campaignWith(const TemporaryFolder& folder, const std::string& faults,
                     const std::string& more) {
  std::filesystem::copy(project("scenarios/skeleton.mi"), folder.path(),
                        std::filesystem::copy_options::overwrite_existing);
  const auto scenario =
      folder.write("faults.toml", slurp(project("scenarios/default.toml")) + "\n" + faults);
  return runShell("$GLIDERCC campaign " + project("missions/figure2.mission") + " --boards 0 " +
                  more + " --scenario " + scenario.string());
}

TEST(Campaign, AReplayedInstructionIsNotObeyedAndTheFlightIsGood) {
  const TemporaryFolder folder;
  const Outcome outcome =
      campaignWith(folder, "[[faults.line]]\nline = \"from_sbc\"\nfrom_s = 100\nreplayed = 0.5\n",
                   "--flights 1");
  EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
}

TEST(Campaign, AFlightControllerThatStartsAgainIsLeftAndTakenAgain) {
  for (const char* keeps : {"false", "true"}) {
    const TemporaryFolder folder;
    std::filesystem::copy(project("scenarios/skeleton.mi"), folder.path());
    const auto scenario = folder.write(
        "restart.toml",
        slurp(project("scenarios/default.toml")) +
            "\n[[faults.flight]]\nat_s = 700\ntakes_s = 30\nkeeps_array = " + keeps + "\n");
    const Flight flight =
        fly(project("missions/figure2.mission") + " --scenario " + scenario.string());
    EXPECT_EQ(flight.outcome.status, 0) << flight.outcome.err;
    size_t taken = 0;
    for (const Event& event : flight.events) {
      taken += event.what.find("the SBC takes control") != std::string::npos ? 1U : 0U;
    }
    EXPECT_EQ(taken, 2U) << keeps;
    EXPECT_LT(flight.column("true_depth").back(), 1.0);
  }
}

TEST(Campaign, RefusesWhatItCannotFly) {
  EXPECT_EQ(runShell("$GLIDERCC campaign").status, 2);
  EXPECT_EQ(runShell("$GLIDERCC campaign " + kMissions + " --flights 0").status, 2);
  EXPECT_EQ(runShell("$GLIDERCC campaign " + kMissions + " --seed -1").status, 2);
  EXPECT_EQ(runShell("$GLIDERCC campaign " + kMissions + " --scenario nowhere").status, 2);
  EXPECT_EQ(runShell("$GLIDERCC campaign " + kMissions + " -o x").status, 2) << "only with --only";
  const Outcome no_csv =
      runShell("$GLIDERCC campaign " + kMissions + " --flights 1 --csv /nowhere/at/all.csv");
  EXPECT_EQ(no_csv.status, 2);
  EXPECT_THAT(no_csv.err, HasSubstr("/nowhere/at/all.csv"));
  const TemporaryFolder folder;
  const auto bad = folder.write("bad.mission", "mission x\n");
  EXPECT_EQ(runShell("$GLIDERCC campaign " + bad.string()).status, 1);
}

TEST(Campaign, AViolationIsReportedAndIsAnError) {
  // Nothing can keep this promise: a hookbeh that waits for ten minutes of silence, in a world
  // that ends before they are over.
  const TemporaryFolder folder;
  std::string skeleton = slurp(project("scenarios/skeleton.mi"));
  const size_t at = skeleton.find("silence_secs(s)     24");
  ASSERT_NE(at, std::string::npos);
  skeleton.replace(at, 22, "silence_secs(s)    600");
  const auto mission_file = folder.write("skeleton.mi", skeleton);
  ASSERT_TRUE(std::filesystem::exists(mission_file));
  std::string world = slurp(project("scenarios/default.toml"));
  world.replace(world.find("21600"), 5, "2560");
  const auto scenario = folder.write("short.toml", world);
  const Outcome outcome = runShell("$GLIDERCC campaign " + project("missions/figure2.mission") +
                                   " --flights 100 --boards 0 --scenario " + scenario.string());
  EXPECT_EQ(outcome.status, 1) << outcome.out << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("the flight does not end in time"));
  EXPECT_THAT(outcome.out, HasSubstr("glidercc campaign " + project("missions/figure2.mission")));
  EXPECT_THAT(outcome.out, HasSubstr("--seed 1 --only "));
}

}  // namespace
}  // namespace glider::tests
