// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// A whole flight of Figure 2's board binaries makes no system call that the board's kernel lacks,
// and flies on where that kernel would answer ENOSYS.

#include "tests/flights/flight.h"

#include <gtest/gtest.h>

#include <set>
#include <sstream>

namespace glider::tests {
namespace {

struct BoardCase {
  std::string board;
  std::string emulator;
  std::string calls;  ///< file of the kernel's system calls
};

/// The names in a .syscalls file.
std::set<std::string> allowedCalls(const BoardCase& board) {
  std::set<std::string> names;
  std::istringstream lines(slurp(project("platforms/boards/" + board.calls)));
  for (std::string line; std::getline(lines, line);) {
    if (!line.empty() && line[0] != '#' && line[0] != '[') {
      names.insert(line.substr(0, line.find_first_of(" \t#")));
    }
  }
  return names;
}

/// The names of the calls in a log of qemu's -strace: "1234 write(…".
std::set<std::string> madeCalls(const std::string& log) {
  std::set<std::string> names;
  std::istringstream lines(log);
  for (std::string line; std::getline(lines, line);) {
    const size_t blank = line.find(' ');
    const size_t bracket = line.find('(');
    if (blank != std::string::npos && bracket != std::string::npos && bracket > blank &&
        line.find_first_not_of("0123456789") == blank) {
      const std::string name = line.substr(blank + 1, bracket - blank - 1);
      // The mission's two processes write into each other's lines.
      if (!name.empty() &&
          name.find_first_not_of("abcdefghijklmnopqrstuvwxyz_0123456789") == std::string::npos) {
        names.insert(name);
      }
    }
  }
  return names;
}

/// Flies the program that shell line `command` runs ("$@" are its options) with Figure 2's mission.
void expectFigure2Times(const TemporaryFolder& folder, const std::string& command) {
  const auto wrapper = folder.write("sbc", "#!/bin/sh\nexec " + command + " \"$@\"\n");
  ASSERT_EQ(runShell("chmod +x " + wrapper.string()).status, 0);
  const Flight flight =
      fly("--sbc " + wrapper.string() + " --scenario " + project("scenarios/default.toml"));
  ASSERT_EQ(flight.outcome.status, 0) << flight.outcome.err;
  const auto transitions = flight.transitions();
  ASSERT_EQ(transitions.size(), 4U);
  EXPECT_EQ(transitions[0].mission_time_s, 500);
  EXPECT_EQ(transitions[3].mission_time_s, 2500);
}

std::string buildFigure2(const TemporaryFolder& folder, const std::string& board) {
  const std::string program = (folder.path() / ("figure2-" + board)).string();
  const Outcome built = runShell("$GLIDERCC build " + project("missions/figure2.mission") +
                                 " --target " + board + " -o " + program);
  EXPECT_EQ(built.status, 0) << built.err;
  return program;
}

class OldKernels : public testing::TestWithParam<BoardCase> {};

TEST_P(OldKernels, HaveEverySystemCallOfAFlight) {
  const TemporaryFolder folder;
  const std::string program = buildFigure2(folder, GetParam().board);
  const std::string log = (folder.path() / "strace").string();
  const std::string mission_log = (folder.path() / "mission.log").string();
  expectFigure2Times(folder, GetParam().emulator + " -strace -D " + log + " " + program +
                                 " --log " + mission_log + " --log-limit 9000 --checkpoint " +
                                 (folder.path() / "checkpoint").string());
  EXPECT_GT(slurp(mission_log).size(), 100U);
  EXPECT_GT(slurp(mission_log + ".old").size(), 100U);
  EXPECT_GT(slurp((folder.path() / "checkpoint").string()).size(), 100U);
  const auto allowed = allowedCalls(GetParam());
  const auto made = madeCalls(slurp(log));
  EXPECT_GE(made.size(), 5U);
  for (const std::string& call : made) {
    EXPECT_TRUE(allowed.contains(call)) << call << " is not in " << GetParam().calls;
  }
}

INSTANTIATE_TEST_SUITE_P(, OldKernels,
                         testing::Values(BoardCase{"ts7800", "qemu-arm -cpu arm926 -r 2.6.21",
                                                   "linux-2.6.21-arm.syscalls"},
                                         BoardCase{"ts5500", "qemu-i386 -cpu 486 -r 2.4.23",
                                                   "linux-2.4.23-i386.syscalls"}),
                         [](const auto& board) { return board.param.board; });

TEST(OldKernelFallbacks, FlyOnWhereTheKernelAnswersEnosys) {
  const TemporaryFolder folder;
  const std::string program = buildFigure2(folder, "ts5500");
  const std::string judge = GLIDER_BINARY_DIR "/tests/old_kernel " +
                            project("platforms/boards/linux-2.4.23-i386.syscalls") + " ";
  if (runShell(judge + program + " --help").status == 77) {
    GTEST_SKIP() << "this machine cannot run i386 programs under seccomp";
  }
  expectFigure2Times(folder, judge + program);
}

}  // namespace
}  // namespace glider::tests
