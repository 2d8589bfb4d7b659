// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// A requirement that does not hold: `check --report` says whether a flight of the simulator breaks
// it too, and names one that does.

#include "tests/flights/flight.h"
#include "tests/support/command.h"

#include <gtest/gtest.h>

#include <cmath>
#include <gmock/gmock.h>
#include <regex>

namespace glider::tests {
namespace {

using testing::HasSubstr;
using testing::Not;

std::string yoThatPromises(const std::string& requirement) {
  return "mission m\n" + requirement +
         "\nstate yo\nbegin\n  flightprofile yo(5 m, 20 m, 26 deg, 26 deg)\n"
         "  sensors depth, missiontime\n  events\n    case missiontime >= 20 min exit\nend\n";
}

TEST(ClosedLoop, NamesAFlightThatBreaksItAndThatFlightDoes) {
  const TemporaryFolder folder;
  const std::string mission =
      folder.write("m.mission", yoThatPromises("require always depth < 18 m")).string();
  const Outcome checked = runShell("$GLIDERCC check --report " + mission);
  EXPECT_EQ(checked.status, 1);
  std::smatch named;
  ASSERT_TRUE(std::regex_search(
      checked.out, named,
      std::regex(
          "a simulated flight violates it too: scenario (\\w+), --seed (\\d+), at ([0-9.]+) s")))
      << checked.out;
  EXPECT_EQ(named[1], "default");
  const Flight flight =
      fly(mission + " --scenario " + named[1].str() + " --seed " + named[2].str());
  const auto time = flight.column("missiontime");
  const auto depth = flight.column("true_depth");
  size_t first = 0;
  while (first < time.size() && !(time[first] >= 0 && depth[first] >= 18)) {
    ++first;
  }
  ASSERT_LT(first, time.size());
  EXPECT_NEAR(time[first], std::stod(named[3].str()), 8);
}

/// At the ports of the other vehicles, and in the bundled scenarios that are for them.
TEST(ClosedLoop, FliesTheOtherVehiclesToo) {
  const TemporaryFolder folder;
  for (const std::string vehicle : {"lauv", "remus100"}) {
    const std::string text = "mission m\nplatform " + vehicle +
                             "\nrequire always depth < 18 m\nstate yo\nbegin\n"
                             "  flightprofile yo(5 m, 20 m)\n  sensors depth, missiontime\n"
                             "  events\n    case missiontime >= 20 min exit\nend\n";
    const Outcome checked =
        runShell("$GLIDERCC check --report " + folder.write("m.mission", text).string());
    EXPECT_EQ(checked.status, 1) << checked.err;
    EXPECT_THAT(checked.out, HasSubstr("a simulated flight violates it too")) << vehicle;
  }
}

/// The water of the scenario is warmer from the start.
TEST(ClosedLoop, CountsNoFlightThatHasBrokenAnAssumption) {
  const TemporaryFolder folder;
  const std::string mission =
      folder
          .write("m.mission",
                 yoThatPromises("assume temp in 0 degC .. 5 degC\nrequire always depth < 18 m"))
          .string();
  const Outcome checked = runShell("$GLIDERCC check --report " + mission);
  EXPECT_EQ(checked.status, 1);
  EXPECT_THAT(checked.out, testing::ContainsRegex("none of [0-9]+ simulated flights violates"));
}

/// The prover's vehicle may turn later than the simulator's does.
TEST(ClosedLoop, SaysThatNoFlightBreaksWhatOnlyTheEnvironmentModelCan) {
  const TemporaryFolder folder;
  const std::string mission =
      folder.write("m.mission", yoThatPromises("require always depth < 24 m")).string();
  const Outcome checked = runShell("$GLIDERCC check --report " + mission);
  EXPECT_EQ(checked.status, 1);
  EXPECT_THAT(checked.out, testing::ContainsRegex("none of [0-9]+ simulated flights violates"));
  const Outcome json = runShell("$GLIDERCC check --report --format json " + mission);
  EXPECT_THAT(json.out, testing::ContainsRegex("\"breaks\": false"));
}

TEST(ClosedLoop, IsNotTriedForWhatIsProvedNorWithoutTheReport) {
  const TemporaryFolder folder;
  const std::string proved =
      folder.write("p.mission", yoThatPromises("require always depth < 40 m")).string();
  EXPECT_THAT(runShell("$GLIDERCC check --report " + proved).out,
              Not(testing::ContainsRegex("simulated flights?")));
  const std::string refuted =
      folder.write("r.mission", yoThatPromises("require always depth < 18 m")).string();
  const Outcome plain = runShell("$GLIDERCC check " + refuted);
  EXPECT_EQ(plain.status, 1);
  EXPECT_THAT(plain.out, Not(testing::ContainsRegex("simulated flights?")));
  EXPECT_THAT(runShell("$GLIDERCC check --report " + refuted).out,
              testing::ContainsRegex("simulated flights?"))
      << "those are the words when it is tried";
}

}  // namespace
}  // namespace glider::tests
