// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The SBC loses its power in flight and gets it back: the mission goes on from its checkpoint, or
// leaves control to the vehicle.

#include "tests/flights/flight.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace glider::tests {
namespace {

/// Figure 2 without SBC power from 800 s on until `to_s`; `board` is an option of sim, or empty;
/// `more` goes to the mission.
Flight flyWithPowerCut(double to_s, const std::string& board, const std::string& more = "") {
  const TemporaryFolder folder;
  std::filesystem::copy(project("scenarios/skeleton.mi"), folder.path());
  const auto scenario = folder.write(
      "cut.toml", slurp(project("scenarios/default.toml")) +
                      "\n[[faults.power]]\nfrom_s = 800\nto_s = " + std::to_string(to_s) + "\n");
  const auto mission =
      folder.write("figure2.mission", slurp(project("missions/figure2.mission")) + more);
  return fly(mission.string() + " --scenario " + scenario.string() + board);
}

size_t count(const Flight& flight, const std::string& what) {
  return static_cast<size_t>(std::ranges::count_if(
      flight.events, [&](const Event& e) { return e.what.find(what) != std::string::npos; }));
}

void expectFigure2Times(const Flight& flight) {
  ASSERT_EQ(flight.outcome.status, 0) << flight.outcome.err;
  const auto transitions = flight.transitions();
  ASSERT_EQ(transitions.size(), 4U);
  const double times[] = {500, 1500, 2000, 2500};
  for (size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(transitions[i].mission_time_s, times[i]);
  }
  EXPECT_NE(transitions[1].what.find("(return)"), std::string::npos) << "the call stack is there";
}

class PowerCut : public testing::TestWithParam<const char*> {};

TEST_P(PowerCut, AShortOneLosesNothingAndHookbehNeverEndsControl) {
  const Flight flight = flyWithPowerCut(812, GetParam());
  expectFigure2Times(flight);
  EXPECT_EQ(count(flight, "the SBC has power again"), 1U);
  EXPECT_EQ(count(flight, "the SBC takes control"), 1U);
  EXPECT_EQ(count(flight, "is silent"), 0U);
}

TEST_P(PowerCut, ALongerOneTakesANewHandshakeAndThenGoesOn) {
  const Flight flight = flyWithPowerCut(900, GetParam());
  expectFigure2Times(flight);
  EXPECT_EQ(count(flight, "is silent"), 1U);
  EXPECT_EQ(count(flight, "the SBC takes control"), 2U);
}

TEST_P(PowerCut, OneThatEndsAtTheSurfaceOnTheTickOfACycleDoesNotEndTheFlight) {
  const Flight flight = flyWithPowerCut(1080, GetParam());
  expectFigure2Times(flight);
  EXPECT_EQ(count(flight, "the SBC has power again"), 1U);
}

TEST_P(PowerCut, ATooLongOneLeavesControlToTheVehicle) {
  const Flight flight = flyWithPowerCut(1110, GetParam());
  EXPECT_EQ(flight.outcome.status, 0) << flight.outcome.err;
  EXPECT_EQ(flight.transitions().size(), 1U);
  EXPECT_EQ(count(flight, "the SBC has power again"), 1U);
  EXPECT_EQ(count(flight, "the SBC takes control"), 1U);
  EXPECT_LT(flight.column("true_depth").back(), 1.0);
}

INSTANTIATE_TEST_SUITE_P(, PowerCut, testing::Values("", " --board host", " --board ts7800"));

TEST_P(PowerCut, TheMissionSaysHowLongIsTooLong) {
  const Flight impatient = flyWithPowerCut(900, GetParam(), "\nresume within 60 s\n");
  EXPECT_EQ(impatient.transitions().size(), 1U);
  EXPECT_EQ(count(impatient, "the SBC takes control"), 1U);
  const Flight patient = flyWithPowerCut(1110, GetParam(), "\nresume within 10 min\n");
  EXPECT_EQ(patient.transitions().size(), 4U);
  EXPECT_EQ(count(patient, "the SBC takes control"), 2U);
}

TEST(PowerCuts, OnAFullCardTheMissionContinuesAndTheVehicleIsInformed) {
  const TemporaryFolder folder;
  const std::string program = (folder.path() / "figure2").string();
  ASSERT_EQ(
      runShell("$GLIDERCC build " + project("missions/figure2.mission") + " -o " + program).status,
      0);
  const auto sbc = folder.write(
      "sbc", "#!/bin/sh\nexec " + program + " --log /dev/full --checkpoint /dev/./full \"$@\"\n");
  ASSERT_EQ(runShell("chmod +x " + sbc.string()).status, 0);
  const Flight flight =
      fly("--sbc " + sbc.string() + " --scenario " + project("scenarios/default.toml"));
  expectFigure2Times(flight);
  EXPECT_EQ(count(flight, "the SBC's log is not written"), 1U);
  EXPECT_EQ(count(flight, "the SBC's checkpoint is not written"), 1U);
}

TEST(PowerCuts, TheSameFlightOnEveryBoard) {
  const Flight here = flyWithPowerCut(812, "");
  EXPECT_EQ(here.csv, flyWithPowerCut(812, " --board ts5500").csv);
  EXPECT_EQ(here.csv, flyWithPowerCut(812, " --board ts7800").csv);
}

}  // namespace
}  // namespace glider::tests
