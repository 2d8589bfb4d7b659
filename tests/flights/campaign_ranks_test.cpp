// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// `mpirun glidercc campaign`: the same table and rows on any number of ranks, also if one is
// killed.

#include "tests/flights/flight.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <gmock/gmock.h>

namespace glider::tests {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

const std::string kMission = project("missions/figure2.mission");

/// The table without the time that it took.
std::string tableOf(const Outcome& outcome) {
  return outcome.out.substr(0, outcome.out.rfind(", "));
}

size_t times(const std::string& text, const std::string& part) {
  size_t count = 0;
  for (size_t at = 0; (at = text.find(part, at)) != std::string::npos; at += part.size()) {
    ++count;
  }
  return count;
}

class CampaignOnRanks : public ::testing::Test {
 protected:
  void SetUp() override {
    if (runShell("command -v mpirun").status != 0) {
      GTEST_SKIP() << "mpirun is not installed (openmpi-bin)";
    }
    if (runShell("test -e $(dirname $GLIDERCC)/../share/glidercc/mpi/ranks.so").status != 0) {
      GTEST_SKIP() << "this glidercc was built without MPI (libopenmpi-dev)";
    }
    // Tests may run as root and on machines with fewer cores than ranks; other tests run as well.
    ::setenv("OMPI_ALLOW_RUN_AS_ROOT", "1", 1);
    ::setenv("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1", 1);
    ::setenv("OMPI_MCA_rmaps_base_oversubscribe", "1", 1);
    ::setenv("OMPI_MCA_hwloc_base_binding_policy", "none", 1);
    ::setenv("PRTE_MCA_rmaps_default_mapping_policy", ":oversubscribe", 1);  // Open MPI 5
    ::setenv("PRTE_MCA_hwloc_default_binding_policy", "none", 1);
    ::setenv("OMPI_MCA_btl_vader_single_copy_mechanism", "none", 1);
    ::setenv("TMPDIR", folder_.path().c_str(), 1);
  }
  void TearDown() override { ::unsetenv("TMPDIR"); }

  [[nodiscard]] std::string file(const std::string& name) const {
    return (folder_.path() / name).string();
  }
  static std::string campaign(const std::string& more) {
    return "$GLIDERCC campaign " + kMission + " --boards 0 --seed 9 " + more;
  }
  static Outcome on(int ranks, const std::string& command) {
    return runShell("mpirun -n " + std::to_string(ranks) + " " + command);
  }

 private:
  const TemporaryFolder folder_;
};

TEST_F(CampaignOnRanks, GivesTheSameTableAndRowsOnAnyNumber) {
  const std::string flights = "$GLIDERCC campaign " + kMission + " " +
                              project("missions/gallery/thermocline.mission") +
                              " --boards 10 --seed 9 --flights 40 ";
  const Outcome alone = runShell(flights + "--csv " + file("alone"));
  ASSERT_EQ(alone.status, 0) << alone.out << alone.err;
  for (const int ranks : {1, 2, 4}) {
    for (const std::string jobs : {"", "--jobs 3 "}) {
      if (ranks != 2 && !jobs.empty()) {
        continue;  // threads beside ranks, once
      }
      const std::string csv = file("ranks");
      const Outcome outcome = on(ranks, flights + jobs + "--csv " + csv);
      EXPECT_EQ(outcome.status, 0) << outcome.err;
      EXPECT_EQ(outcome.err, "");
      EXPECT_EQ(tableOf(outcome), tableOf(alone)) << ranks << " ranks " << jobs;
      EXPECT_EQ(slurp(csv), slurp(file("alone"))) << ranks << " ranks " << jobs;
    }
  }
}

TEST_F(CampaignOnRanks, MoreRanksThanFlights) {
  const Outcome alone = runShell(campaign("--flights 2 --csv " + file("alone")));
  const Outcome outcome = on(5, campaign("--flights 2 --csv " + file("ranks")));
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(tableOf(outcome), tableOf(alone));
  EXPECT_EQ(slurp(file("ranks")), slurp(file("alone")));
}

TEST_F(CampaignOnRanks, EveryRankFlies) {
  // The ranks show what they do by the processor time that each has used.
  const Outcome outcome = on(3, "sh -c '" + campaign("--flights 90 > /dev/null; times >> ") +
                                    file("times") + ".$OMPI_COMM_WORLD_RANK'");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  double most = 0, least = 1e9;
  for (const char* rank : {"0", "1", "2"}) {
    const std::string used = slurp(file("times") + "." + rank);
    // Two lines, of the shell and of its children: "0m1.23s 0m0.01s".
    const size_t line = used.find('\n');
    ASSERT_NE(line, std::string::npos) << rank;
    const double minutes = std::atof(used.c_str() + line + 1);
    const double seconds = 60 * minutes + std::atof(used.c_str() + used.find('m', line) + 1);
    most = std::max(most, seconds);
    least = std::min(least, seconds);
  }
  EXPECT_GT(least, most / 3) << "each compiles the mission and flies about a third of the flights";
}

/// Which process is killed: a rank, and how many flights have been written before it.
struct Kill {
  const char* rank;
  int rows;
};

class CampaignRankKilled : public CampaignOnRanks, public testing::WithParamInterface<Kill> {};

TEST_P(CampaignRankKilled, ResumesAsIfNothingHadHappened) {
  const std::string flights = campaign("--flights 80 ");
  const Outcome alone = runShell(flights + "--csv " + file("alone"));
  ASSERT_EQ(alone.status, 0) << alone.out << alone.err;
  const std::string cut = file("cut");
  const std::string pids = file("pid.");
  const std::string wait = "n=0; while [ $n -lt 1200 ] && [ $(wc -l < " + cut +
                           " 2>/dev/null || echo 0) -lt " + std::to_string(GetParam().rows) +
                           " ]; do sleep 0.05; n=$((n+1)); done; kill -KILL $(cat " + pids +
                           GetParam().rank + "); wait $!";
  const Outcome killed =
      runShell("mpirun -n 3 sh -c 'echo $$ > " + pids + "$OMPI_COMM_WORLD_RANK; exec " + flights +
               "--csv " + cut + "' & " + wait);
  EXPECT_NE(killed.status, 0);
  const std::string before = slurp(cut);
  ASSERT_GE(times(before, "\n"), static_cast<size_t>(GetParam().rows));
  ASSERT_LT(times(before, "\n"), 82U) << "it was over before the signal";
  const Outcome resumed = on(2, flights + "--resume " + cut);
  EXPECT_EQ(resumed.status, 0) << resumed.out << resumed.err;
  EXPECT_EQ(slurp(cut), slurp(file("alone")));
  EXPECT_EQ(tableOf(resumed), tableOf(alone));
}

INSTANTIATE_TEST_SUITE_P(, CampaignRankKilled,
                         testing::Values(Kill{"0", 20}, Kill{"1", 3}, Kill{"2", 60}),
                         [](const auto& test) {
                           return std::string("rank") + test.param.rank + "after" +
                                  std::to_string(test.param.rows);
                         });

TEST_F(CampaignOnRanks, CtrlCPrintsTheTableOfTheFlightsSoFar) {
  const std::string cut = file("cut");
  const Outcome outcome = runShell(
      "mpirun -n 2 " + campaign("--flights 5000 --csv " + cut) +
      " & n=0; while [ $n -lt 1200 ] && [ $(wc -l < " + cut +
      " 2>/dev/null || echo 0) -lt 20 ]; do sleep 0.05; n=$((n+1)); done; kill -INT $!; wait $!");
  EXPECT_NE(outcome.status, 0);
  EXPECT_THAT(outcome.out, ContainsRegex("interrupted after [0-9]+ of 5000 flights"));
  EXPECT_THAT(outcome.out, HasSubstr("--resume " + cut));
}

TEST_F(CampaignOnRanks, ErrorsAreReportedOnceWithTheirExitCode) {
  const auto once = [&](const std::string& command, int status, const std::string& what) {
    const Outcome outcome = on(3, command);
    EXPECT_EQ(outcome.status, status) << command << outcome.err;
    EXPECT_EQ(times(outcome.err, what), 1U) << command << "\n" << outcome.err;
    EXPECT_EQ(times(outcome.out, "flights, seed"), 0U);
  };
  std::ofstream(file("bad.mission")) << "mission x\n";
  once("$GLIDERCC campaign " + file("bad.mission"), 1, "error: ");
  once("$GLIDERCC campaign /nowhere.mission", 2, "/nowhere.mission");
  once(campaign("--flights 3 --csv /nowhere/at/all.csv"), 2, "/nowhere/at/all.csv");
  once(campaign("--flights 0"), 2, "--flights");
  once(campaign("--only 3"), 2, "without mpirun");
  once("$GLIDERCC campaign", 2, "MISSION");
  once("$GLIDERCC campain x", 2, "no command `campain`");
}

TEST_F(CampaignOnRanks, AViolationIsTheExitCodeOfMpirun) {
  std::string skeleton = slurp(project("scenarios/skeleton.mi"));
  const size_t at = skeleton.find("silence_secs(s)     24");
  ASSERT_NE(at, std::string::npos);
  std::ofstream(file("skeleton.mi")) << skeleton.replace(at, 22, "silence_secs(s)    600");
  std::string world = slurp(project("scenarios/default.toml"));
  std::ofstream(file("short.toml")) << world.replace(world.find("21600"), 5, "2560");
  const Outcome outcome = on(2, campaign("--flights 40 --scenario " + file("short.toml")));
  EXPECT_EQ(outcome.status, 1) << outcome.out << outcome.err;
  EXPECT_EQ(times(outcome.out, "40 flights, seed"), 1U);
  EXPECT_THAT(outcome.out, HasSubstr("the flight does not end in time"));
}

TEST_F(CampaignOnRanks, ARankThatWouldFlyOtherwiseIsRefused) {
  const auto refused = [&](const std::string& first, const std::string& other,
                           const std::string& why) {
    const Outcome outcome = runShell("mpirun -n 1 " + first + " : -n 1 " + other);
    EXPECT_EQ(outcome.status, 2) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr(why));
    EXPECT_EQ(outcome.out, "");
  };
  refused(campaign("--flights 9"), campaign("--flights 8"), "GL9389");
  // The second rank has no emulator of a board.
  const std::string boards = "$GLIDERCC campaign " + kMission + " --flights 9 --boards 50";
  refused(boards, "env PATH=/nowhere " + boards, "not of `cm4, pizero2, ts5500, ts7800`");
  // A working folder that lacks the mission.
  std::ofstream(file("here.mission")) << slurp(kMission);
  const Outcome elsewhere = runShell("cd " + file("") +
                                     "; mpirun -n 1 $GLIDERCC campaign here.mission --flights 2 : "
                                     "-wdir / -n 1 $GLIDERCC campaign here.mission --flights 2");
  EXPECT_EQ(elsewhere.status, 2) << elsewhere.err;
  EXPECT_THAT(elsewhere.err, ContainsRegex("rank 1 on `.*` cannot fly:\n"));
  EXPECT_EQ(times(elsewhere.err, "cannot read `here.mission`"), 1U) << elsewhere.err;
}

TEST_F(CampaignOnRanks, PartsAreMerged) {
  const Outcome alone = runShell(campaign("--flights 31 --csv " + file("alone")));
  ASSERT_EQ(alone.status, 0) << alone.err;
  std::string resumes;
  for (const std::string part : {"1", "2", "3"}) {
    const std::string command = campaign("--flights 31 --part " + part + "/3 --csv " + file(part));
    const Outcome flown = part == "2" ? on(2, command) : runShell(command);
    EXPECT_EQ(flown.status, 0) << flown.err;
    EXPECT_THAT(flown.out, HasSubstr("part " + part + " of 3: 1"));
    EXPECT_THAT(times(slurp(file(part)), "\n"), testing::AnyOf(2 + 10U, 2 + 11U));
    resumes += " --resume " + file(part);
  }
  const Outcome merged = runShell(campaign("--flights 31 --csv " + file("all") + resumes));
  EXPECT_EQ(merged.status, 0) << merged.err;
  EXPECT_EQ(slurp(file("all")), slurp(file("alone")));
  EXPECT_EQ(tableOf(merged), tableOf(alone));
}

/// The command with a copy of its data that has no MPI.
class CampaignWithoutMpi : public CampaignOnRanks {
 protected:
  [[nodiscard]] std::string share() const {
    return "rm -rf " + file("share") +
           "; cp -rs $(realpath $(dirname $GLIDERCC)/../share/glidercc) " + file("share") +
           "; rm -rf " + file("share") + "/mpi; export GLIDERCC_SHARE=" + file("share") + "; ";
  }
};

TEST_F(CampaignWithoutMpi, FliesAloneAndRefusesSeveralRanks) {
  const Outcome alone = runShell(share() + campaign("--flights 2"));
  EXPECT_EQ(alone.status, 0) << alone.err;
  const Outcome one = runShell(share() + "mpirun -n 1 " + campaign("--flights 2"));
  EXPECT_EQ(one.status, 0) << one.err;
  EXPECT_EQ(tableOf(one), tableOf(alone)) << "one rank needs no MPI";
  const Outcome refused = runShell(share() + "mpirun -n 3 " + campaign("--flights 2"));
  EXPECT_EQ(refused.status, 2) << refused.err;
  EXPECT_EQ(refused.out, "");
  EXPECT_EQ(times(refused.err,
                  "cannot fly one campaign on 3 ranks: this glidercc was built without "
                  "MPI [GL9388"),
            1U)
      << refused.err;
  EXPECT_THAT(refused.err, HasSubstr("libopenmpi-dev"));
}

// srun without --mpi: as many processes as tasks, which do not know of each other.
TEST_F(CampaignWithoutMpi, ALauncherThatMpiDoesNotKnowIsRefused) {
  const Outcome refused =
      runShell("SLURM_PROCID=0 SLURM_STEP_NUM_TASKS=4 " + campaign("--flights 2"));
  EXPECT_EQ(refused.status, 2) << refused.out << refused.err;
  EXPECT_EQ(refused.out, "");
  EXPECT_THAT(refused.err, HasSubstr("on 4 ranks: the MPI of this glidercc finds 1 of them"));
}

TEST(CampaignCommand, IsNotLinkedWithMpi) {
  const Outcome outcome = runShell("ldd $GLIDERCC");
  EXPECT_THAT(outcome.out, HasSubstr("libc.so"));
  EXPECT_THAT(outcome.out, Not(HasSubstr("libmpi")));
}

}  // namespace
}  // namespace glider::tests
