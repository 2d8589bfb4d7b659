// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The program of a mission for a REMUS 100, on each board, at a vehicle that is reached over UDP.

#include "tests/flights/flight.h"
#include "tests/support/command.h"
#include "tests/unit/runtime/recon_udp_vehicle.h"

#include <gtest/gtest.h>

#include <chrono>
#include <future>
#include <gmock/gmock.h>
#include <string>

namespace glider::tests {
namespace {

using runtime::testing::ReconUdpVehicle;
using runtime::testing::UdpPeer;
using testing::HasSubstr;
using testing::Not;

constexpr char kThreeLegs[] =
    "mission two\nplatform remus100\n"
    "state down\nbegin\n  flightprofile level(20 m)\n  flightroute heading(90 deg)\n"
    "  sensors missiontime, depth\n  events\n    case depth >= 18 m goto up\nend\n"
    "state up\nbegin\n  flightprofile level(10 m)\n  flightroute heading(270 deg)\n"
    "  sensors missiontime, depth\n  events\n    case depth <= 12 m goto rest\nend\n"
    "state rest\nbegin\n  flightprofile level(10 m)\n  flightroute heading(270 deg)\n"
    "  sensors missiontime, depth\n  events\n    case missiontime >= 90 exit\nend\n";

class Remus100Udp : public testing::TestWithParam<std::string> {
 protected:
  /// Starts the program with the vehicle's address.
  [[nodiscard]] std::future<Outcome> start(const ReconUdpVehicle& vehicle) const {
    const std::string board = GetParam(), program = (folder_.path() / "program").string();
    const std::string mission = folder_.write("two.mission", kThreeLegs).string();
    const Outcome built =
        runShell("$GLIDERCC build " + mission + " --target " + board + " -o " + program);
    EXPECT_EQ(built.status, 0) << built.err;
    const std::string emulator = board == "ts7800"   ? "qemu-arm "
                                 : board == "ts5500" ? "qemu-i386 -cpu 486 -r 2.4.23 "
                                                     : "";
    return std::async(std::launch::async, runShell,
                      "timeout 60 " + emulator + program +
                          " --udp 127.0.0.2:" + std::to_string(vehicle.peer.port()) + " --log " +
                          (folder_.path() / "log").string());
  }
  const TemporaryFolder folder_;
};

/// The vehicle's seconds are as long as the program needs for an answer.
TEST_P(Remus100Udp, FliesToItsEndAsOverStandardInput) {
  ReconUdpVehicle vehicle;
  vehicle.answer_ms = 500;
  vehicle.pause_ms = 15;
  std::future<Outcome> program = start(vehicle);
  const UdpPeer stranger(0, 3);
  ASSERT_LT(vehicle.secondsUntil([&] { return vehicle.told_depth_m == 20; }, 400), 400);
  auto over = vehicle.state();
  over["mode"].number = 0x03;
  stranger.send(recon_described::lineOf("State", over), vehicle.peer.port());
  ASSERT_LT(vehicle.secondsUntil([&] { return vehicle.told_depth_m == 10; }, 100), 100);
  vehicle.seconds(6);
  vehicle.restart(8);
  ASSERT_LT(vehicle.secondsUntil([&] { return vehicle.told_depth_m == 10; }, 100), 100);
  EXPECT_GE(vehicle.asks, 2) << "more often if the computer was busy";
  const auto ended = [&] {
    return program.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
  };
  ASSERT_LT(vehicle.secondsUntil(ended, 300), 300);
  EXPECT_FALSE(vehicle.obeys());
  EXPECT_GE(vehicle.shortest_pause_s, 0.0019);
  const Outcome outcome = program.get();
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  const std::string at = "127.0.0.2:" + std::to_string(vehicle.peer.port());
  EXPECT_THAT(outcome.err, HasSubstr("datagrams arrive from " + at + "\n"));
  EXPECT_THAT(outcome.err, HasSubstr("1 datagram(s) passed over: not from " + at + "\n"));
  const Outcome log = runShell("$GLIDERCC log " + (folder_.path() / "log").string());
  EXPECT_EQ(log.status, 0) << log.err;
  const Flight there = fly((folder_.path() / "two.mission").string() + " --board " + GetParam());
  ASSERT_EQ(there.transitions().size(), 3U) << there.outcome.err;
  size_t at_text = 0;
  for (const Event& event : there.transitions()) {
    const std::string what = event.what.substr(0, event.what.find(')'));  // the log has more there
    at_text = log.out.find(what, at_text);
    ASSERT_NE(at_text, std::string::npos) << what << " in\n" << log.out;
    at_text += what.size();
  }
  EXPECT_EQ(log.out.find(" → ", at_text), std::string::npos) << log.out;
}

INSTANTIATE_TEST_SUITE_P(Boards, Remus100Udp, testing::Values("host", "ts7800", "ts5500"),
                         [](const auto& board) { return board.param; });

/// Only the programs of missions for such a vehicle have the option.
TEST(Remus100UdpOption, IsThatOfItsProgramsAlone) {
  const TemporaryFolder folder;
  const std::string remus = folder.write("two.mission", kThreeLegs).string();
  const auto said = [&](const std::string& mission, const std::string& arguments) {
    return runShell("cd " + folder.path().string() + " && $GLIDERCC build " + mission +
                    " --target host -o program > /dev/null && ./program " + arguments);
  };
  EXPECT_THAT(said(remus, "--help").err, HasSubstr("--udp ADDRESS[:PORT]"));
  for (const char* wrong : {"--udp 1.2.3", "--udp remus", "--udp 1.2.3.4:", "--udp 1.2.3.4:70000",
                            "--udp", "--tcp 1.2.3.4:6006"}) {
    const Outcome refused = said(remus, wrong);
    EXPECT_EQ(refused.status, 1) << wrong;
    EXPECT_THAT(refused.err, HasSubstr(std::string("cannot make sense of `") + wrong + "`"));
  }
  const std::string slocum = project("missions/figure2.mission");
  EXPECT_THAT(said(slocum, "--help").err, Not(HasSubstr("--udp")));
  EXPECT_EQ(said(slocum, "--udp 127.0.0.1").status, 1);
}

}  // namespace
}  // namespace glider::tests
