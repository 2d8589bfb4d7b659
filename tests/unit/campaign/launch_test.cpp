// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What launchers leave in the environment, and what is refused without MPI.

#include "campaign/campaign.h"
#include "support/diagnostics/ids/flights.h"
#include "tests/support/command.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <gmock/gmock.h>

namespace glider::campaign {
namespace {

using ::testing::HasSubstr;

class LaunchOf : public ::testing::Test {
 protected:
  LaunchOf() { forget(); }
  ~LaunchOf() override {
    forget();
    ::unsetenv("GLIDERCC_SHARE");
  }
  static void forget() {
    for (const char* name : {"OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE", "PMI_RANK", "PMI_SIZE",
                             "SLURM_PROCID", "SLURM_STEP_NUM_TASKS", "SLURM_NTASKS"}) {
      ::unsetenv(name);
    }
  }
  /// Rank and size with these variables.
  static std::pair<size_t, size_t> with(const char* rank, const char* size, const char* ranks,
                                        const char* sizes) {
    forget();
    ::setenv(rank, ranks, 1);
    ::setenv(size, sizes, 1);
    const Launch launch = launchOf();
    return {launch.rank, launch.size};
  }
  using Pair = std::pair<size_t, size_t>;
};

TEST_F(LaunchOf, IsOneProcessWithoutALauncher) {
  EXPECT_EQ(launchOf().size, 1U);
  EXPECT_EQ(launchOf().rank, 0U);
}

TEST_F(LaunchOf, KnowsTheLaunchers) {
  EXPECT_EQ(with("OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE", "2", "4"), Pair(2, 4));
  EXPECT_EQ(with("PMI_RANK", "PMI_SIZE", "1", "3"), Pair(1, 3));
  EXPECT_EQ(with("SLURM_PROCID", "SLURM_STEP_NUM_TASKS", "7", "8"), Pair(7, 8));
  EXPECT_EQ(with("SLURM_PROCID", "SLURM_NTASKS", "0", "8"), Pair(0, 1)) << "a batch script";
  EXPECT_EQ(with("OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE", "0", "1"), Pair(0, 1));
  EXPECT_EQ(with("OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE", "0", "4x"), Pair(0, 1));
}

// Slurm starts mpirun's daemons by srun, one on each machine.
TEST_F(LaunchOf, MpirunInAJobOfSlurmCountsItsOwnRanks) {
  ::setenv("SLURM_PROCID", "1", 1);
  ::setenv("SLURM_STEP_NUM_TASKS", "2", 1);
  ::setenv("OMPI_COMM_WORLD_RANK", "0", 1);
  ::setenv("OMPI_COMM_WORLD_SIZE", "1", 1);
  EXPECT_EQ(launchOf().size, 1U);
  EXPECT_EQ(launchOf().rank, 0U);
}

TEST_F(LaunchOf, OneProcessNeedsNoMpi) {  // accepts: GL9388
  ::setenv("GLIDERCC_SHARE", "/nowhere", 1);
  const auto ranks = joinRanks(launchOf());
  ASSERT_TRUE(ranks);
  EXPECT_EQ(*ranks, nullptr);
}

TEST_F(LaunchOf, SeveralProcessesWithoutMpiAreRefused) {  // refused: GL9388
  ::setenv("GLIDERCC_SHARE", "/nowhere", 1);
  const auto missing = joinRanks({.rank = 0, .size = 4});
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().id, support::diagnostics::ranksNotJoined);
  EXPECT_THAT(missing.error().message,
              HasSubstr("on 4 ranks: this glidercc was built without MPI"));
  EXPECT_THAT(missing.error().hint, HasSubstr("libopenmpi-dev"));
}

TEST_F(LaunchOf, AFileThatIsNotALibraryIsRefused) {
  const tests::TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "mpi");
  (void)folder.write("mpi/ranks.so", "not a library");
  ::setenv("GLIDERCC_SHARE", folder.path().c_str(), 1);
  const auto damaged = joinRanks({.rank = 0, .size = 4});
  ASSERT_FALSE(damaged);
  EXPECT_THAT(damaged.error().message, HasSubstr("cannot load MPI: "));
}

}  // namespace
}  // namespace glider::campaign
