// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/ports/process_sbc_port.h"
#include "tests/unit/simulator/fake_sbc.h"
#include "tests/unit/simulator/flights.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <signal.h>

namespace glider::simulator {
namespace {

const std::string kProgram = std::string(GLIDER_BINARY_DIR) + "/tests/simulator_sbc_program";

size_t openDescriptors() {
  size_t count = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator("/proc/self/fd")) {
    ++count;
  }
  return count;
}

SimulationSetup setupFor(std::unique_ptr<SbcPort> sbc) {
  SimulationSetup setup = shippedSetup("default");
  setup.duration_s = 600;
  setup.sbc = std::move(sbc);
  return setup;
}

std::unique_ptr<ProcessSbcPort> start(std::vector<std::string> command, double hang_secs = 10) {
  auto port = ProcessSbcPort::start("host", std::move(command), hang_secs);
  EXPECT_TRUE(port) << port.error().message;
  return std::move(*port);
}

TEST(ProcessSbc, FliesTheSameAsInProcess) {
  const size_t before = openDescriptors();
  const support::Trace over_pty = fly(setupFor(start({kProgram, "{port}"})));
  const support::Trace in_process = fly(setupFor(std::make_unique<FakeSbc>(FakePilot::Plan{})));
  EXPECT_NE(findEvent(over_pty, EventId::SbcTakesControl), nullptr) << eventText(over_pty);
  EXPECT_EQ(traceToCsv(over_pty), traceToCsv(in_process));
  EXPECT_EQ(over_pty.way, "host");
  EXPECT_EQ(openDescriptors(), before) << "a descriptor has leaked";
}

TEST(ProcessSbc, KilledLeavesNoZombie) {
  auto port = start({kProgram, "{port}"});
  const pid_t pid = port->pid();
  port->kill();
  EXPECT_FALSE(port->alive());
  EXPECT_EQ(port->exitReason(), "killed");
  EXPECT_NE(::kill(pid, 0), 0) << "it is reaped";
  SimulationSetup setup = setupFor(start({kProgram, "{port}"}));
  setup.kill_sbc_at_s = 200;
  const support::Trace trace = fly(std::move(setup));
  ASSERT_NE(findEvent(trace, EventId::SbcGone), nullptr) << eventText(trace);
  EXPECT_EQ(findEvent(trace, EventId::SbcGone)->why, "killed");
  EXPECT_NE(findEvent(trace, EventId::SbcSilent), nullptr);
}

TEST(ProcessSbc, TellsHowAProgramEnded) {
  const support::Trace ended = fly(setupFor(start({kProgram, "{port}", "exit", "20"})));
  ASSERT_NE(findEvent(ended, EventId::SbcGone), nullptr) << eventText(ended);
  EXPECT_EQ(findEvent(ended, EventId::SbcGone)->why, "exited with status 7");
  const support::Trace never = fly(setupFor(start({"/bin/true"})));
  ASSERT_NE(findEvent(never, EventId::SbcGone), nullptr) << eventText(never);
  EXPECT_EQ(findEvent(never, EventId::SbcGone)->why, "exited with status 0");
}

/// On a busy machine a program may close its port long before its end can be taken.
TEST(ProcessSbc, WaitsForTheEndOfAProgramThatHasClosedItsPort) {
  const support::Trace ended = fly(setupFor(start({kProgram, "{port}", "linger", "20"})));
  ASSERT_NE(findEvent(ended, EventId::SbcGone), nullptr) << eventText(ended);
  EXPECT_EQ(findEvent(ended, EventId::SbcGone)->why, "exited with status 7");
}

TEST(ProcessSbc, EndsAProgramThatHasClosedItsPortAndStays) {
  const support::Trace trace = fly(setupFor(start({kProgram, "{port}", "close", "20"}, 0.3)));
  ASSERT_NE(findEvent(trace, EventId::SbcGone), nullptr) << eventText(trace);
  EXPECT_EQ(findEvent(trace, EventId::SbcGone)->why, "closed its serial port");
}

TEST(ProcessSbc, EndsAHungProgram) {
  const support::Trace trace = fly(setupFor(start({kProgram, "{port}", "hang", "20"}, 0.3)));
  ASSERT_NE(findEvent(trace, EventId::SbcGone), nullptr) << eventText(trace);
  EXPECT_EQ(findEvent(trace, EventId::SbcGone)->why, "hung");
}

TEST(ProcessSbc, SaysWhyItCannotStart) {
  const size_t before = openDescriptors();
  const auto missing = ProcessSbcPort::start("host", {"/no/such/program", "{port}"});
  ASSERT_FALSE(missing);
  EXPECT_EQ(support::code(missing.error().id), "GL9150");  // accepts: GL9150 — the tests above
  EXPECT_NE(missing.error().message.find("/no/such/program"), std::string::npos);
  EXPECT_FALSE(ProcessSbcPort::start("host", {}));
  EXPECT_EQ(openDescriptors(), before);
}

}  // namespace
}  // namespace glider::simulator
