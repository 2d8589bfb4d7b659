// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The program of a mission for a LAUV, on each board, at a vehicle that is reached over TCP.

#include "tests/support/command.h"
#include "tests/unit/runtime/imc_tcp_vehicle.h"

#include <gtest/gtest.h>

#include <chrono>
#include <future>
#include <gmock/gmock.h>
#include <string>

namespace glider::tests {
namespace {

using runtime::testing::TcpVehicle;
using testing::HasSubstr;

constexpr char kMission[] =
    "mission two\nplatform lauv\n"
    "state down\nbegin\n  flightprofile level(20 m)\n  flightroute heading(90 deg)\n"
    "  sensors missiontime, depth\n  events\n    case missiontime >= 40 goto up\nend\n"
    "state up\nbegin\n  flightprofile level(10 m)\n  flightroute heading(270 deg)\n"
    "  sensors missiontime, depth\n  events\n    case missiontime >= 80 exit\nend\n";

class LauvTcp : public testing::TestWithParam<std::string> {
 protected:
  /// Starts the program with the vehicle's address.
  [[nodiscard]] std::future<Outcome> start(const TcpVehicle& vehicle) const {
    const std::string board = GetParam(), program = (folder_.path() / "program").string();
    const std::string mission = folder_.write("two.mission", kMission).string();
    const Outcome built =
        runShell("$GLIDERCC build " + mission + " --target " + board + " -o " + program);
    EXPECT_EQ(built.status, 0) << built.err;
    const std::string emulator = board == "ts7800"   ? "qemu-arm "
                                 : board == "ts5500" ? "qemu-i386 -cpu 486 -r 2.4.23 "
                                                     : "";
    return std::async(std::launch::async, runShell,
                      "timeout 60 " + emulator + program +
                          " --tcp 127.0.0.1:" + std::to_string(vehicle.peer.port()) + " --log " +
                          (folder_.path() / "log").string());
  }
  const TemporaryFolder folder_;
};

/// The vehicle's seconds are as long as the program needs for an answer, or 20 moments.
TEST_P(LauvTcp, FliesToItsEndThroughALostConnection) {
  TcpVehicle vehicle;
  vehicle.moments_ms = 50;
  std::future<Outcome> program = start(vehicle);
  runShell("sleep 0.3");
  vehicle.peer.listen();
  ASSERT_LT(vehicle.secondsUntil([&] { return vehicle.toldDepth() == 20; }, 200), 200);
  vehicle.depth_m = 19.8;
  vehicle.seconds(10);
  vehicle.peer.reset();
  ASSERT_LT(vehicle.secondsUntil([&] { return vehicle.peer.accepted() == 2; }, 200), 200);
  ASSERT_LT(vehicle.secondsUntil([&] { return vehicle.toldDepth() == 10; }, 200), 200);
  ASSERT_LT(vehicle.secondsUntil([&] { return vehicle.stops > 0; }, 200), 200);
  const auto ended = [&] {
    return program.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
  };
  ASSERT_LT(vehicle.secondsUntil(ended, 200), 200);
  const Outcome outcome = program.get();
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  const std::string at = "127.0.0.1:" + std::to_string(vehicle.peer.port());
  EXPECT_THAT(outcome.err, HasSubstr("no connection to " + at + "; it is tried again\n"));
  EXPECT_THAT(outcome.err, HasSubstr("connected to " + at + "\n"));
  const Outcome log = runShell("$GLIDERCC log " + (folder_.path() / "log").string());
  EXPECT_EQ(log.status, 0) << log.err;
  EXPECT_THAT(log.out, HasSubstr("down → up"));
}

INSTANTIATE_TEST_SUITE_P(Boards, LauvTcp, testing::Values("host", "ts7800", "ts5500"),
                         [](const auto& board) { return board.param; });

/// Only the programs of missions for such a vehicle have the option.
TEST(LauvTcpOption, IsThatOfItsProgramsAlone) {
  const TemporaryFolder folder;
  const std::string lauv = folder.write("two.mission", kMission).string();
  const auto said = [&](const std::string& mission, const std::string& arguments) {
    return runShell("cd " + folder.path().string() + " && $GLIDERCC build " + mission +
                    " --target host -o program > /dev/null && ./program " + arguments);
  };
  const std::string slocum = std::string(GLIDER_SOURCE_DIR) + "/missions/figure2.mission";
  EXPECT_THAT(said(lauv, "--help").err, HasSubstr("--tcp ADDRESS:PORT"));
  EXPECT_THAT(said(slocum, "--help").err, Not(HasSubstr("--tcp")));
  for (const char* wrong : {"--tcp 1.2.3.4", "--tcp lauv:6006", "--tcp"}) {
    const Outcome refused = said(lauv, wrong);
    EXPECT_EQ(refused.status, 1);
    EXPECT_THAT(refused.err, HasSubstr(std::string("cannot make sense of `") + wrong + "`"));
  }
  EXPECT_EQ(said(slocum, "--tcp 127.0.0.1:6006").status, 1);
}

}  // namespace
}  // namespace glider::tests
