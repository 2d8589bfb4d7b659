// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// A mission's program at a vehicle that is steered by RECON: runtime/recon/README.md.

#include "tests/unit/runtime/power_cut_store.h"
#include "tests/unit/runtime/recon_vehicle.h"

#include <cmath>
#include <utility>

namespace glider::runtime::recon {
namespace {

using namespace hooks::recon;
using testing::ReconVehicle;
using testing::TwoDepths;

/// From nothing to a mission that flies.
void begin(ReconVehicle& vehicle) {
  vehicle.seconds(12);
  ASSERT_EQ(vehicle.asks, 1);
  ASSERT_TRUE(vehicle.obeys());
  ASSERT_NE(vehicle.context(), nullptr);
  ASSERT_EQ(vehicle.told_depth, 20);
}

TEST(ReconBackseat, FliesAMissionFromItsFirstQueryToItsEnd) {
  TwoDepths mission;
  mission.end_s = 60;
  ReconVehicle vehicle(mission.mission);
  begin(vehicle);
  EXPECT_EQ(vehicle.queries, 1);
  EXPECT_EQ(vehicle.told_speed, 1.25);
  EXPECT_NEAR(vehicle.told_heading, 1.5 * 180 / 3.14159265, 0.01);
  vehicle.depth_m = 18;
  vehicle.temperature = 10;
  vehicle.seconds(3);
  EXPECT_EQ(vehicle.told_depth, 40);
  EXPECT_TRUE(vehicle.texts.empty()) << "RECON has no such message";
  vehicle.seconds(70);
  EXPECT_TRUE(vehicle.finished);
  EXPECT_GE(vehicle.ends, 1);
  EXPECT_LE(vehicle.ends, 2) << "the vehicle said that it has the control";
  EXPECT_FALSE(vehicle.obeys());
  EXPECT_EQ(vehicle.asks, 1);
}

TEST(ReconBackseat, SaysThatItIsThereWhileItDoesNotSteer) {
  TwoDepths mission;
  mission.mission.start_depth_cm = 150;
  ReconVehicle vehicle(mission.mission);
  vehicle.depth_m = 10;
  vehicle.seconds(20);
  EXPECT_GE(vehicle.alive, 17);
  EXPECT_EQ(vehicle.goals, 0);
  vehicle.depth_m = 0;
  vehicle.seconds(12);
  ASSERT_TRUE(vehicle.obeys());
  const int alive = vehicle.alive, goals = vehicle.goals;
  vehicle.seconds(10);
  EXPECT_EQ(vehicle.alive, alive);
  EXPECT_EQ(vehicle.goals, goals + 10);
}

TEST(ReconBackseat, TheEndIsAskedForAgainWhileTheVehicleDoesNotObey) {
  TwoDepths mission;
  mission.end_s = 30;
  ReconVehicle vehicle(mission.mission);
  begin(vehicle);
  vehicle.deaf_to_end = true;
  while (vehicle.ends == 0) {
    vehicle.second();
  }
  const int goals = vehicle.goals;
  for (int answers = 1; answers < static_cast<int>(SeatSession::kReleaseAnswers); ++answers) {
    EXPECT_EQ(vehicle.told_depth, 0) << "the last goal may stay in force";
    EXPECT_EQ(vehicle.told_speed, 0.8);
    EXPECT_EQ(vehicle.ends, answers);
    EXPECT_EQ(vehicle.goals, goals + answers - 1);
    EXPECT_FALSE(vehicle.finished) << answers;
    vehicle.second();
  }
  vehicle.seconds(20);
  EXPECT_TRUE(vehicle.finished);
  EXPECT_EQ(vehicle.ends, static_cast<int>(SeatSession::kReleaseAnswers));
}

/// The program before this one has left it in the override.
TEST(ReconBackseat, AProgramThatDoesNotGoOnEndsTheOverride) {
  for (const bool obeys : {true, false}) {
    TwoDepths mission;
    mission.mission.resume_within = 120;
    testing::RecordingStore store;
    const GliderRuntimeOptions options{{}, nullptr, store.store(), 7};
    ReconVehicle before(mission.mission, nullptr, &options);
    begin(before);
    before.seconds(30);
    const LinkFacts checkpoint{.clock = static_cast<uint32_t>(before.now_s)};
    ReconVehicle vehicle(mission.mission, &checkpoint, &options);
    vehicle.now_s = before.now_s + 1000;
    vehicle.depth_m = 20;
    vehicle.mode = obeys ? Mode::Override : Mode::Launched;
    vehicle.deaf_to_end = true;
    vehicle.seconds(10);
    EXPECT_EQ(vehicle.finished, !obeys);
    EXPECT_EQ(vehicle.ends > 5, obeys);
    EXPECT_EQ(vehicle.told_depth, obeys ? 0 : -1);
    vehicle.deaf_to_end = false;
    vehicle.seconds(3);
    EXPECT_TRUE(vehicle.finished);
    EXPECT_FALSE(vehicle.obeys());
    EXPECT_EQ(vehicle.asks, 0);
  }
}

TEST(ReconBackseat, DoesNotAskUnderWater) {
  TwoDepths mission;
  mission.mission.start_depth_cm = 150;
  ReconVehicle vehicle(mission.mission);
  vehicle.depth_m = 1.6;
  vehicle.seconds(60);
  EXPECT_EQ(vehicle.asks, 0);
  EXPECT_EQ(vehicle.context(), nullptr);
  vehicle.depth_m = 1.5;
  vehicle.seconds(12);
  EXPECT_EQ(vehicle.asks, 1);
  EXPECT_NE(vehicle.context(), nullptr);
}

/// A reading from hours ago would let it ask at depth.
TEST(ReconBackseat, DoesNotAskWhileTheDepthIsNotKnown) {
  TwoDepths mission;
  mission.mission.start_depth_cm = 150;
  ReconVehicle vehicle(mission.mission);
  vehicle.mode = 0x02;  // it may not be asked
  vehicle.depth_m = 0.5;
  vehicle.seconds(20);
  vehicle.mode = Mode::Launched;
  vehicle.depth_m = std::nan("");
  vehicle.seconds(20);
  EXPECT_EQ(vehicle.asks, 0);
  vehicle.depth_m = 0.5;
  vehicle.seconds(5);
  EXPECT_EQ(vehicle.asks, 1);
}

TEST(ReconBackseat, IsToldTheSurfaceUntilItsFirstCommand) {
  TwoDepths mission;
  const LinkFacts checkpoint{.clock = 1'699'999'990};  // so the program first decides to go on
  ReconVehicle vehicle(mission.mission, &checkpoint);
  vehicle.mode = Mode::Override;
  int before = 0;
  for (int second = 0; second < 30; ++second) {
    vehicle.second();
    if (vehicle.context() == nullptr && vehicle.goals > 0) {
      ++before;
      EXPECT_EQ(vehicle.told_depth, 0);
      EXPECT_EQ(vehicle.told_speed, 0.8);
      EXPECT_NEAR(vehicle.told_heading, 30, 1e-5);
    }
  }
  EXPECT_GT(before, 0);
  EXPECT_NE(vehicle.context(), nullptr);
}

/// All that the vehicle obeyed in a flight, with its bytes in pieces.
std::vector<std::pair<double, double>> flownInPieces(size_t piece) {
  TwoDepths mission;
  mission.end_s = 300;
  ReconVehicle vehicle(mission.mission);
  vehicle.piece = piece;
  std::vector<std::pair<double, double>> told;
  for (int second = 0; second < 340; ++second) {
    vehicle.depth_m = second < 5 ? 0 : 10 + 5 * std::sin(second / 20.0);
    vehicle.temperature = 13 + 3 * std::sin(second / 15.0);
    vehicle.second();
    told.emplace_back(vehicle.now_s, vehicle.told_depth);
  }
  EXPECT_TRUE(vehicle.finished) << piece;
  EXPECT_EQ(vehicle.damaged(), 0U) << piece;
  return told;
}

TEST(ReconBackseat, FliesTheSameHoweverTheBytesArrive) {
  const auto whole = flownInPieces(1U << 20U);
  for (const size_t piece : {1U, 7U, 64U, 1000U}) {
    EXPECT_EQ(flownInPieces(piece), whole) << piece;
  }
}

TEST(ReconBackseat, DamagedLinesAreCountedAndMissedAndNothingElse) {
  TwoDepths mission;
  ReconVehicle vehicle(mission.mission);
  begin(vehicle);
  EXPECT_EQ(vehicle.damaged(), 0U);
  vehicle.sayBytes("noise");
  vehicle.second();
  EXPECT_EQ(vehicle.damaged(), 5U);
  for (int times = 0; times < 10; ++times) {
    std::string line = testing::reconLine(vehicle.stateAt(vehicle.now_s, Mode::Over));
    line[10] ^= 1;
    vehicle.sayBytes(line);
    vehicle.seconds(2);
  }
  EXPECT_TRUE(vehicle.obeys());
  EXPECT_EQ(vehicle.told_depth, 20);
  EXPECT_EQ(vehicle.asks, 1);
}

/// The vehicle, or its operator, has ended the override: nothing that we know says why.
TEST(ReconBackseat, WhatTheVehicleTakesBackIsNotAskedForAgain) {
  for (const uint8_t mode : {uint8_t{Mode::Launched}, uint8_t{Mode::Over},
                             uint8_t{kNotDeployed | Mode::Override}, uint8_t{kNotDeployed}}) {
    TwoDepths mission;
    ReconVehicle vehicle(mission.mission);
    begin(vehicle);
    const int goals = vehicle.goals;
    vehicle.mode = mode;
    vehicle.seconds(120);
    EXPECT_EQ(vehicle.asks, 1) << int{mode};
    EXPECT_EQ(vehicle.goals, goals) << int{mode};
    vehicle.mode = Mode::Override;
    vehicle.seconds(20);
    EXPECT_EQ(vehicle.goals, goals) << "for as long as the program runs";
    EXPECT_EQ(vehicle.ends, 0);
  }
}

TEST(ReconBackseat, WhatEndedInSilenceIsAskedForAgainAndTheMissionGoesOn) {
  for (const double silence_s : {4.0, 5.0}) {
    TwoDepths mission;
    ReconVehicle vehicle(mission.mission);
    begin(vehicle);
    vehicle.depth_m = 18;
    vehicle.temperature = 10;
    vehicle.seconds(5);
    ASSERT_EQ(vehicle.told_depth, 40);
    vehicle.now_s += silence_s - 1;
    vehicle.mode = Mode::Launched;
    vehicle.second();
    vehicle.seconds(20);
    EXPECT_EQ(vehicle.obeys(), silence_s >= Takeover::kSilenceSecs);
    EXPECT_EQ(vehicle.asks, silence_s >= Takeover::kSilenceSecs ? 2 : 1);
    EXPECT_EQ(vehicle.told_depth, 40) << "the state that it was in";
  }
}

/// Silence long ago does not excuse what the vehicle takes back now.
TEST(ReconBackseat, SilenceThatIsOverDoesNotCount) {
  TwoDepths mission;
  ReconVehicle vehicle(mission.mission);
  begin(vehicle);
  vehicle.now_s += 20;
  vehicle.seconds(5);
  ASSERT_TRUE(vehicle.obeys());
  vehicle.mode = Mode::Launched;
  vehicle.seconds(30);
  EXPECT_EQ(vehicle.asks, 1);
}

TEST(ReconBackseat, AMissionThatIsOverBeforeTheLaunchIsNotTaken) {
  TwoDepths mission;
  ReconVehicle vehicle(mission.mission);
  for (const uint8_t mode : {uint8_t{Mode::Over}, uint8_t{kNotDeployed | Mode::Launched}}) {
    vehicle.mode = mode;
    vehicle.seconds(20);
    EXPECT_EQ(vehicle.asks, 0);
  }
  vehicle.mode = Mode::Launched;
  begin(vehicle);
}

TEST(ReconBackseat, AVehicleThatAsksForTheSbcGetsIt) {
  TwoDepths mission;
  mission.mission.start_depth_cm = 150;
  ReconVehicle vehicle(mission.mission);
  vehicle.mode = Mode::Override;
  vehicle.seconds(12);
  EXPECT_EQ(vehicle.asks, 0);
  EXPECT_EQ(vehicle.told_depth, 20);
}

/// Proofs begin near the surface. That the program has seen the surface before, under the vehicle's
/// own mission, does not count.
TEST(ReconBackseat, AVehicleThatObeysAtDepthIsBroughtUpBeforeTheMissionBegins) {
  TwoDepths mission;
  mission.mission.start_depth_cm = 150;
  ReconVehicle vehicle(mission.mission);
  vehicle.mode = 0x02;  // it may not be asked
  vehicle.depth_m = 0.5;
  vehicle.seconds(20);
  vehicle.depth_m = 50;
  vehicle.mode = Mode::Override;
  for (; vehicle.depth_m > 1.5; vehicle.depth_m -= 1) {
    vehicle.second();
    ASSERT_EQ(vehicle.context(), nullptr) << vehicle.depth_m;
    EXPECT_EQ(vehicle.told_depth, 0);
  }
  vehicle.depth_m = std::nan("");
  vehicle.seconds(5);
  EXPECT_EQ(vehicle.context(), nullptr) << "the depth is not known";
  vehicle.depth_m = 1.5;
  vehicle.seconds(5);
  EXPECT_NE(vehicle.context(), nullptr);
  vehicle.depth_m = 10;
  vehicle.seconds(5);
  EXPECT_EQ(vehicle.told_depth, 20) << "once begun, at any depth";
}

TEST(ReconBackseat, ModesThatAreNotKnownChangeNothing) {
  TwoDepths mission;
  ReconVehicle vehicle(mission.mission);
  vehicle.mode = 0x02;
  vehicle.seconds(20);
  EXPECT_EQ(vehicle.asks, 0);
  vehicle.mode = Mode::Launched;
  begin(vehicle);
  const int goals = vehicle.goals;
  for (const uint8_t mode : {uint8_t{0x0E}, uint8_t{0x02}, uint8_t{0x00}}) {
    vehicle.mode = mode;
    vehicle.seconds(3);
  }
  EXPECT_EQ(vehicle.goals, goals + 9);
}

TEST(ReconBackseat, WithoutADateThereIsNoCycle) {
  TwoDepths mission;
  ReconVehicle vehicle(mission.mission);
  vehicle.knows_time = false;
  vehicle.seconds(10);
  EXPECT_EQ(vehicle.queries, 10);
  EXPECT_EQ(vehicle.alive, 0);
  vehicle.say(TimeSet{12345});
  vehicle.seconds(5);
  EXPECT_EQ(vehicle.queries, 15) << "a computer that does not know the time";
  vehicle.knows_time = true;
  vehicle.seconds(12);
  EXPECT_EQ(vehicle.queries, 15);
  EXPECT_EQ(vehicle.told_depth, 20);
}

TEST(ReconBackseat, MidnightIsOneSecondLikeAnother) {
  TwoDepths mission;
  ReconVehicle vehicle(mission.mission);
  vehicle.now_s = 86400 * 20000 - 40;
  begin(vehicle);
  const double before = vehicle.context()->mission_time;
  const int goals = vehicle.goals;
  vehicle.seconds(60);
  EXPECT_NEAR(vehicle.context()->mission_time, before + 60, 1e-6);
  EXPECT_EQ(vehicle.goals, goals + 60);
  EXPECT_EQ(vehicle.queries, 1);
}

TEST(ReconBackseat, AStateThatWasOvertakenSaysNothing) {
  TwoDepths mission;
  ReconVehicle vehicle(mission.mission);
  begin(vehicle);
  const int goals = vehicle.goals;
  for (int times = 0; times < 10; ++times) {
    vehicle.say(vehicle.stateAt(vehicle.now_s - 1, Mode::Launched));
    vehicle.second();
  }
  EXPECT_EQ(vehicle.asks, 1);
  EXPECT_EQ(vehicle.goals, goals + 10);
}

TEST(ReconBackseat, AClockThatIsSetBackGoesOn) {
  TwoDepths mission;
  ReconVehicle vehicle(mission.mission);
  begin(vehicle);
  const int goals = vehicle.goals;
  vehicle.now_s -= 1000;
  vehicle.seconds(5);
  const double before = vehicle.context()->mission_time;
  vehicle.seconds(5);
  EXPECT_EQ(vehicle.context()->mission_time, before + 5);
  EXPECT_EQ(vehicle.goals, goals + 10);
  EXPECT_TRUE(vehicle.obeys());
}

TEST(ReconBackseat, SeveralStatesInASecondAreOneCycle) {
  TwoDepths mission;
  ReconVehicle vehicle(mission.mission);
  begin(vehicle);
  const int goals = vehicle.goals;
  for (int second = 0; second < 10; ++second) {
    vehicle.second();
    for (const double later_s : {0.1, 0.5, 0.9}) {
      vehicle.say(vehicle.stateAt(vehicle.now_s + later_s, vehicle.mode));
      vehicle.hand();
    }
  }
  EXPECT_EQ(vehicle.goals, goals + 10);
}

TEST(ReconBackseat, ADepthBeyondTheVehiclesIsNeverSent) {
  TwoDepths mission;
  mission.deeper_m = 50.1;
  ReconVehicle vehicle(mission.mission);
  begin(vehicle);
  vehicle.temperature = 10;
  for (int second = 0; second < 30; ++second) {
    vehicle.second();
    EXPECT_LE(vehicle.told_depth, 50);
  }
}

TEST(ReconBackseat, AProgramThatGoesOnDecidesBeforeTheVehicleIsAsked) {
  for (const bool goes_on : {false, true}) {
    TwoDepths mission;
    const LinkFacts checkpoint{.clock = 1'699'999'990};
    ReconVehicle vehicle(mission.mission, goes_on ? &checkpoint : nullptr);
    vehicle.depth_m = goes_on ? 10 : 0;
    while (vehicle.alive == 0 && vehicle.now_s < 1.7e9 + 20) {
      vehicle.second();
    }
    EXPECT_EQ(vehicle.asks, goes_on ? 0 : 1) << "in its first answer";
    vehicle.seconds(10);
    EXPECT_EQ(vehicle.asks, 1) << "at any depth";
  }
}

TEST(ReconBackseat, ARealVehicleDoesNotBecomeASimulatedOne) {
  TwoDepths mission;
  ReconVehicle vehicle(mission.mission);
  begin(vehicle);
  vehicle.say(SimulationText{textOf("virtual-time")});
  vehicle.seconds(5);
  EXPECT_TRUE(vehicle.texts.empty());
}

TEST(ReconBackseat, TextsThatALineCannotHoldAreTold) {
  TwoDepths mission;
  mission.mission.name = "b#n*";
  ReconVehicle vehicle(mission.mission);
  vehicle.say(SimulationText{textOf("virtual-time")});
  vehicle.seconds(12);
  EXPECT_EQ(std::ranges::count(vehicle.texts, "mission,b?n?"), 1);
}

TEST(ReconBackseat, OnlyASimulatedVehicleIsToldOfTheMission) {
  for (const bool simulated : {false, true}) {
    TwoDepths mission;
    ReconVehicle vehicle(mission.mission);
    if (simulated) {
      vehicle.say(SimulationText{textOf("virtual-time")});
    }
    vehicle.seconds(20);
    vehicle.temperature = 10;
    vehicle.seconds(5);
    const auto told = [&](const std::string& begin) {
      return std::ranges::count_if(
          vehicle.texts, [&](const std::string& text) { return text.starts_with(begin); });
    };
    EXPECT_EQ(told("mission,bench"), simulated ? 1 : 0);
    EXPECT_EQ(told("transition,"), simulated ? 1 : 0);
    EXPECT_EQ(told("state,") > 20, simulated);
    EXPECT_TRUE(!simulated || vehicle.texts.back().starts_with("state,"));
  }
}

}  // namespace
}  // namespace glider::runtime::recon
