// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The mission's log on a board outlives the program: a reboot in the middle of a flight keeps it.

#include "tests/flights/flight.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace glider::tests {
namespace {

size_t countOf(const std::string& text, const std::string& part) {
  size_t count = 0;
  for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++count;
  }
  return count;
}

TEST(MissionLog, AProgramThatStartsAgainWritesAfterTheOldLog) {
  const TemporaryFolder folder;
  const std::string program = (folder.path() / "figure2").string();
  const std::string log = (folder.path() / "log.csv").string();
  ASSERT_EQ(
      runShell("$GLIDERCC build " + project("missions/figure2.mission") + " -o " + program).status,
      0);
  const auto sbc =
      folder.write("sbc", "#!/bin/sh\nexec " + program + " --log " + log + " \"$@\"\n");
  ASSERT_EQ(runShell("chmod +x " + sbc.string()).status, 0);
  const std::string flight =
      "--sbc " + sbc.string() + " --scenario " + project("scenarios/default.toml");
  ASSERT_EQ(fly(flight).outcome.status, 0);
  const std::string first = slurp(log);
  EXPECT_EQ(countOf(first, "time_s,record,"), 1U);
  std::ofstream(log, std::ios::app) << "1234,val";  // the power was cut here
  ASSERT_EQ(fly(flight).outcome.status, 0);
  EXPECT_EQ(slurp(log), first + "1234,val\n" + first);
}

TEST(MissionLog, TheSimulatorsIsOfOneFlight) {
  const TemporaryFolder folder;
  const std::string output = (folder.path() / "flight").string();
  const std::string sim = "$GLIDERCC sim " + project("missions/figure2.mission") +
                          " --board host -o " + output + " --scenario " +
                          project("scenarios/default.toml");
  ASSERT_EQ(runShell(sim).status, 0);
  const std::string first = slurp(output + "/mission-log.csv");
  EXPECT_EQ(countOf(first, "time_s,record,"), 1U);
  ASSERT_EQ(runShell(sim).status, 0);
  EXPECT_EQ(slurp(output + "/mission-log.csv"), first);
}

}  // namespace
}  // namespace glider::tests
