// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The compiled missions under faults of every kind, by `glidercc campaign`; scripts/soak/faults
// flies more of the same.

#include "tests/flights/flight.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <gmock/gmock.h>

namespace glider::tests {
namespace {

using testing::HasSubstr;

const std::string kMissions =
    project("missions/figure2.mission") + " " + project("missions/gallery/thermocline.mission");

TEST(Campaign, EveryKindOfFaultEndsAsStated) {
  const TemporaryFolder folder;
  const std::string csv = (folder.path() / "flights.csv").string();
  const Outcome outcome =
      runShell("$GLIDERCC campaign " + kMissions + " --flights 168 --seed 1 --csv " + csv);
  EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("SBC power cut"));
  EXPECT_THAT(outcome.out, HasSubstr("168 flights, seed 1"));
  const std::string rows = slurp(csv);
  EXPECT_EQ(std::ranges::count(rows, '\n'), 169);
  EXPECT_THAT(rows, HasSubstr("exited after hand-back"));
  EXPECT_THAT(rows, HasSubstr(",handed back,"));
}

TEST(Campaign, IsTheSeedsAloneHoweverManyFlyAtATime) {
  const TemporaryFolder folder;
  const auto csv = [&](const std::string& jobs, const std::string& seed) {
    const std::string file = (folder.path() / ("jobs" + jobs + seed)).string();
    const Outcome outcome =
        runShell("$GLIDERCC campaign " + kMissions + " --scenario figure5 --flights 42 --jobs " +
                 jobs + " --seed " + seed + " --csv " + file);
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
      runShell("$GLIDERCC campaign " + mission + " --flights 1000 --only 11 -o " + out);
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

TEST(Campaign, AViolationIsToldAndIsAnError) {
  // Nothing can keep this promise: a hookbeh that waits for five minutes of silence, in a world
  // that ends before they are over.
  const TemporaryFolder folder;
  std::string skeleton = slurp(project("scenarios/skeleton.mi"));
  const size_t at = skeleton.find("silence_secs(s)     24");
  ASSERT_NE(at, std::string::npos);
  skeleton.replace(at, 22, "silence_secs(s)    900");
  const auto mission_file = folder.write("skeleton.mi", skeleton);
  ASSERT_TRUE(std::filesystem::exists(mission_file));
  std::string world = slurp(project("scenarios/default.toml"));
  world.replace(world.find("21600"), 5, "600");
  const auto scenario = folder.write("short.toml", world);
  const Outcome outcome = runShell("$GLIDERCC campaign " + project("missions/figure2.mission") +
                                   " --flights 21 --scenario " + scenario.string());
  EXPECT_EQ(outcome.status, 1) << outcome.out << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("the flight does not end in time"));
  EXPECT_THAT(outcome.out, HasSubstr("--only NUMBER"));
}

}  // namespace
}  // namespace glider::tests
