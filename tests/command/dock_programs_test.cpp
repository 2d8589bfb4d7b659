// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The check at the dock with real programs behind a pseudo-terminal: those that `build --dialect
// extctl` writes, for this computer and for a board under its emulator.

#include "hooks/transport/host/pty.h"
#include "platforms/load/load_platform.h"
#include "support/program.h"
#include "tests/support/command.h"
#include "vehicles/slocum/dock/dock.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <gmock/gmock.h>
#include <string>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

namespace glider::tests {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::IsEmpty;
using vehicles::DockCheck;
using vehicles::DockEnd;
using vehicles::DockVerdict;

/// Of real time, s: long enough for an emulator on a busy machine.
constexpr double kCycle = 0.3;

/// A folder of the port for the mission figure2, as far as the check needs it.
struct Built {
  explicit Built(const std::string& target, const std::string& options = "") {
    const Outcome outcome = runShell("cd " + folder.path().string() +
                                     " && $GLIDERCC build " GLIDER_SOURCE_DIR
                                     "/missions/figure2.mission --dialect extctl --target " +
                                     target + options + " -o p");
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    plan.mission = "sampleMission";
    plan.extctl =
        *slocum::readExtctlFile("extctl.ini", slurp(path() / "vehicle/config/extctl.ini"));
    const std::string file = slurp(path() / "vehicle/missions/samplemi.mi");
    const std::string mark = "u_mission_param_l(nodim) ";
    plan.port.program =
        static_cast<uint32_t>(std::stoul(file.substr(file.find(mark) + mark.size())));
    plan.port.greatest_depth_m = 200;
    plan.port.steepest_pitch_rad = 0.8;
  }
  [[nodiscard]] fs::path path() const { return folder.path() / "p"; }

  TemporaryFolder folder;
  slocum::PortPlan plan;
};

/// A program at the other end of a pseudo-terminal.
class Program {
 public:
  explicit Program(std::vector<std::string> command) : pty_(*hooks::Pty::open()) {
    command.insert(command.end(), {"--port", pty_.name(), "--baud", "9600"});
    const int nowhere = ::open("/dev/null", O_RDWR);
    pid_ = support::startProgram(command, nowhere, nowhere);
    ::close(nowhere);
  }
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;
  ~Program() { end(); }
  void end() {
    if (pid_ > 0) {
      ::kill(pid_, SIGKILL);
      ::waitpid(pid_, nullptr, 0);
      pid_ = 0;
    }
  }
  [[nodiscard]] hooks::Pty& pty() { return pty_; }

 private:
  hooks::Pty pty_;
  pid_t pid_ = 0;
};

/// A control cycle lasts `cycle_s` here.
vehicles::DockResult check(
    const Built& built, Program& program, double cycle_s,
    const std::function<void(double)>& during = [](double) {}) {
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  const auto platform = platforms::loadPlatform(GLIDER_SOURCE_DIR "/platforms/slocum.toml");
  vehicles::DockHost host;
  host.line = program.pty().stream();
  host.baud = 9600;
  host.now = [begin] { return std::chrono::duration<double>(Clock::now() - begin).count(); };
  host.sleep = [&](double seconds) {
    during(host.now());
    std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
  };
  host.stop = [] { return false; };
  host.errors = [] { return std::nullopt; };
  host.progress = [](const std::string&) {};
  slocum::DockTimes times;
  times.listen_s = 1;
  times.cycle_s = cycle_s;
  times.whole_s = 1 + 40 * cycle_s;
  return slocum::checkAtDock({.plan = built.plan,
                              .sensors = built.plan.extctl,
                              .platform = *platform,
                              .program = "sbc/figure2",
                              .part = vehicles::DockPart::Auto,
                              .times = times},
                             host);
}

std::vector<std::string> notGood(const vehicles::DockResult& result) {
  std::vector<std::string> found;
  for (const DockCheck& one : result.checks) {
    // How fast it answers depends on what else this machine does.
    if (one.verdict != DockVerdict::Good && one.id != "answer-time") {
      found.push_back(one.id + ": " + one.measured);
    }
  }
  return found;
}

TEST(DockPrograms, ThoseOfTheFolderAreGood) {
  const std::pair<const char*, std::vector<std::string>> boards[] = {{"host", {}},
                                                                     {"ts7800", {"qemu-arm"}}};
  for (const auto& [board, emulator] : boards) {
    const Built built(board);
    std::vector<std::string> command = emulator;
    command.push_back((built.path() / "sbc/figure2").string());
    Program program(command);
    const auto result = check(built, program, kCycle);
    EXPECT_THAT(notGood(result), IsEmpty()) << board;
    EXPECT_EQ(result.checks.size(), 12U);
    if (emulator.empty()) {
      EXPECT_THAT(notGood(check(built, program, kCycle)),
                  testing::ElementsAre(HasSubstr("has said it before")))
          << "the same program once more";
    }
  }
}

TEST(DockPrograms, TheProgramOfAnotherFolderIsFound) {
  const Built built("host");
  const Built deeper("host", " --max-depth 150");
  Program program({(deeper.path() / "sbc/figure2").string()});
  const auto result = check(built, program, kCycle);
  EXPECT_THAT(notGood(result), testing::Contains(HasSubstr("program: not that of this folder")));
}

TEST(DockPrograms, AProgramThatEndsClosesTheLine) {
  const Built built("host");
  Program program({(built.path() / "sbc/figure2").string()});
  bool ended = false;
  const auto result = check(built, program, kCycle, [&](double now_s) {
    if (now_s > 6 && !ended) {
      ended = true;
      program.pty().releaseUserSide();
      program.end();
    }
  });
  EXPECT_EQ(result.end, DockEnd::LineGone);
  EXPECT_THAT(notGood(result), testing::Contains(HasSubstr("device: it was closed or unplugged")));
  EXPECT_GT(result.checks.size(), 10U) << "what was known is reported";
}

}  // namespace
}  // namespace glider::tests
