// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// A program on a serial line of its own, with socat in between: what a real SBC is to the
// simulator.

#include "tests/flights/flight.h"
#include "tests/support/command.h"

#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <gmock/gmock.h>
#include <regex>
#include <sstream>

namespace glider::tests {
namespace {

/// Two pseudo-terminals that socat joins, and the mission's own program at one of them.
class SerialSbc : public testing::Test {
 protected:
  void connect(const std::string& mission) {
    join("$GLIDERCC build " + mission + " --target host -o program");
  }
  /// For the port for a backseat driver: the folder `p`.
  void connectPort(const std::string& mission) {
    join("$GLIDERCC build " + mission +
         " --dialect extctl -o p && cp p/sbc/figure2 program && echo ' --baud 9600' > options");
  }
  void join(const std::string& build) {
    const Outcome begun = runShell(
        "cd " + folder() + " && touch options && " + build +
        " && { socat pty,raw,echo=0,link=a pty,raw,echo=0,link=b & "
        "echo $! > pids; for i in $(seq 200); do test -e a && test -e b && break; sleep 0.05; "
        "done; ./program --port b $(cat options) & echo $! >> pids; } > /dev/null 2>&1 < "
        "/dev/null");
    ASSERT_EQ(begun.status, 0) << begun.err;
  }
  void TearDown() override { runShell("kill $(cat " + folder() + "/pids)"); }

  [[nodiscard]] std::string folder() const { return folder_.path().string(); }
  [[nodiscard]] std::string device() const { return folder() + "/a"; }

  TemporaryFolder folder_;
};

TEST_F(SerialSbc, InLockstepTheFlightIsThatInProcess) {
  const std::string mission = project("missions/figure2.mission");
  connect(mission);
  const Flight serial = fly(mission + " --serial " + device() + " --lockstep");
  EXPECT_EQ(serial.outcome.status, 0) << serial.outcome.err;
  ASSERT_EQ(serial.transitions().size(), 4U);
  EXPECT_EQ(serial.csv, fly(mission).csv);
}

TEST_F(SerialSbc, InRealTimeASecondIsASecondAndTheClockOfTheSbcCounts) {
  const std::string mission =
      folder_
          .write("m.mission",
                 "mission m\nstate a\nbegin\n  flightprofile yo(5 m, 20 m, 26 deg, 26 deg)\n"
                 "  sensors depth, missiontime\n  events\n    case missiontime >= 4 s goto b\nend\n"
                 "state b\nbegin\n  flightprofile yo(5 m, 10 m, 26 deg, 26 deg)\n"
                 "  sensors depth, missiontime\n  events\n    case missiontime >= 1 h exit\nend\n")
          .string();
  std::ifstream file(project("scenarios/default.toml"));
  std::stringstream text;
  text << file.rdbuf();
  std::string world =
      std::regex_replace(text.str(), std::regex("duration_s = \\d+"), "duration_s = 25");
  world = std::regex_replace(world, std::regex("skeleton = \"skeleton.mi\""),
                             "skeleton = \"" + project("scenarios/skeleton.mi") + "\"");
  const std::string scenario = folder_.write("short.toml", world).string();
  connect(mission);
  const auto begin = std::chrono::steady_clock::now();
  const Flight flight = fly(mission + " --scenario " + scenario + " --serial " + device());
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
  EXPECT_EQ(flight.outcome.status, 0) << flight.outcome.err;
  EXPECT_GE(took.count(), 25);
  const auto transitions = flight.transitions();
  ASSERT_EQ(transitions.size(), 1U) << flight.outcome.out;
  EXPECT_GE(transitions[0].mission_time_s, 4);
  EXPECT_LE(transitions[0].mission_time_s, 9);
}

TEST_F(SerialSbc, AFolderForThePortFliesInLockstepAsInProcess) {
  connectPort(project("missions/figure2.mission"));
  const Flight serial = fly(folder() + "/p --serial " + device() + " --lockstep");
  EXPECT_EQ(serial.outcome.status, 0) << serial.outcome.err;
  EXPECT_GE(serial.transitions().size(), 3U);
  EXPECT_EQ(serial.csv, fly(folder() + "/p").csv);
}

TEST_F(SerialSbc, AFolderForThePortFliesInRealTime) {
  connectPort(project("missions/figure2.mission"));
  const auto begin = std::chrono::steady_clock::now();
  const Flight flight = fly(folder() + "/p --serial " + device() + " --duration 45s");
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
  EXPECT_GE(took.count(), 45);
  EXPECT_EQ(flight.outcome.err.find("GL9372"), std::string::npos)
      << "the program was in control: " << flight.outcome.err;
}

TEST(SerialDeviceOfSim, IsRefusedWithAWordIfItIsNotThere) {
  const Outcome outcome = runShell("$GLIDERCC sim --serial /dev/nothing-here");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_THAT(outcome.err, testing::HasSubstr("GL9100"));
  EXPECT_EQ(runShell("$GLIDERCC sim --lockstep --no-sbc").status, 2);
}

}  // namespace
}  // namespace glider::tests
