// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// A mission's program at a vehicle that is steered by IMC: runtime/imc/README.md.

#include "tests/unit/runtime/imc_vehicle.h"

#include <utility>

namespace glider::runtime::imc {
namespace {

using namespace hooks::imc;
using testing::ImcVehicle;
using testing::TwoDepths;

EstimatedState stateNow() {
  EstimatedState state;
  state.lat = 0.72;
  state.lon = -0.15;
  state.depth = 0.2F;
  state.alt = -1;
  return state;
}

/// A state alone: the vehicle sends many of them between two reports of its plan.
void sayState(ImcVehicle& vehicle) {
  vehicle.now_s += 1;
  vehicle.say(stateNow());
  vehicle.hand();
}

/// The line drops; nothing is received for so long.
void drop(ImcVehicle& vehicle, double seconds) {
  vehicle.closed = true;
  vehicle.hand();
  vehicle.now_s += seconds;
  vehicle.closed = false;
}

/// Asked for a start, which the vehicle did not read.
void askInVain(ImcVehicle& vehicle) {
  vehicle.seconds(1);
  vehicle.deaf = true;
  vehicle.seconds(2);
  ASSERT_EQ(vehicle.starts, 0);
}

/// From nothing to a mission that flies.
void begin(ImcVehicle& vehicle) {
  vehicle.seconds(12);
  ASSERT_EQ(vehicle.starts, 1);
  ASSERT_EQ(vehicle.plan, "glidercc");
  ASSERT_NE(vehicle.context(), nullptr);
  ASSERT_EQ(vehicle.toldDepth(), 20);
}

TEST(ImcBackseat, FliesAMissionFromTheStartOfItsPlanToItsEnd) {
  TwoDepths mission;
  mission.end_s = 60;
  ImcVehicle vehicle(mission.mission);
  begin(vehicle);
  EXPECT_EQ(vehicle.told.speed.value.value, 1.25);
  vehicle.depth_m = 18;
  vehicle.temperature = 10;
  vehicle.seconds(3);
  EXPECT_EQ(vehicle.toldDepth(), 40);
  EXPECT_EQ(vehicle.count("mission,bench"), 1);
  EXPECT_EQ(vehicle.count("transition,"), 1);
  EXPECT_EQ(vehicle.references + vehicle.starts, vehicle.heartbeats - 1)
      << "in each answer but the first, in which nothing was known of the vehicle";
  vehicle.seconds(70);
  EXPECT_TRUE(vehicle.finished);
  EXPECT_GE(vehicle.stops, 1);
  EXPECT_LE(vehicle.stops, 2) << "the vehicle said that it was stopped";
  EXPECT_EQ(vehicle.plan, std::nullopt);
  EXPECT_EQ(vehicle.starts, 1);
}

TEST(ImcBackseat, TheEndIsAskedForAgainWhileTheVehicleDoesNotHear) {
  TwoDepths mission;
  mission.end_s = 30;
  ImcVehicle vehicle(mission.mission);
  begin(vehicle);
  vehicle.seconds(15);
  ASSERT_FALSE(vehicle.finished);
  for (int second = 0; second < 30 && !vehicle.finished; ++second) {
    vehicle.plan = "glidercc";  // it did not obey
    vehicle.second();
  }
  EXPECT_TRUE(vehicle.finished);
  EXPECT_GE(vehicle.stops, static_cast<int>(Backseat::kReleaseCycles));
  EXPECT_LE(vehicle.stops, static_cast<int>(Backseat::kReleaseCycles) + 1);
}

TEST(ImcBackseat, DoesNotStartUnderWater) {
  TwoDepths mission;
  ImcVehicle vehicle(mission.mission);
  vehicle.depth_m = 2.5;
  vehicle.seconds(60);
  EXPECT_EQ(vehicle.starts, 0);
  EXPECT_EQ(vehicle.context(), nullptr);
  vehicle.depth_m = 0.5;
  vehicle.seconds(12);
  EXPECT_EQ(vehicle.starts, 1);
  EXPECT_NE(vehicle.context(), nullptr);
}

TEST(ImcBackseat, IsToldToStayAtTheSurfaceUntilItsFirstCommand) {
  TwoDepths mission;
  ImcVehicle vehicle(mission.mission);
  while (vehicle.context() == nullptr && vehicle.now_s < 1.7e9 + 60) {
    vehicle.second();
    if (vehicle.context() == nullptr && vehicle.references > 0) {
      EXPECT_EQ(vehicle.toldDepth(), 0);
      EXPECT_NEAR(vehicle.told.lat, 0.72, 1e-9);
    }
  }
  EXPECT_NE(vehicle.context(), nullptr);
}

/// All that the vehicle obeyed in a flight, with its bytes in pieces.
struct Told {
  std::vector<std::pair<double, double>> depths;
  std::vector<std::string> texts;
  bool operator==(const Told&) const = default;
};
Told flownInPieces(size_t piece) {
  TwoDepths mission;
  mission.end_s = 300;
  ImcVehicle vehicle(mission.mission);
  vehicle.piece = piece;
  Told told;
  for (int second = 0; second < 340; ++second) {
    vehicle.depth_m = second < 5 ? 0 : 10 + 5 * std::sin(second / 20.0);
    vehicle.temperature = 13 + 3 * std::sin(second / 15.0);
    vehicle.second();
    told.depths.emplace_back(vehicle.now_s, vehicle.toldDepth());
  }
  EXPECT_TRUE(vehicle.finished) << piece;
  EXPECT_EQ(vehicle.damaged(), 0U) << piece;
  told.texts = vehicle.texts;
  return told;
}

TEST(ImcBackseat, FliesTheSameHoweverTheBytesArrive) {
  const Told whole = flownInPieces(1U << 20U);
  EXPECT_GT(whole.texts.size(), 5U);
  for (const size_t piece : {1U, 7U, 64U, 1000U}) {
    EXPECT_EQ(flownInPieces(piece), whole) << piece;
  }
}

TEST(ImcBackseat, ALostPacketIsMissedAndNothingElse) {
  for (const uint16_t lost :
       {PlanControlState::kId, FollowRefState::kId, Temperature::kId, EstimatedState::kId}) {
    TwoDepths mission;
    ImcVehicle vehicle(mission.mission);
    begin(vehicle);
    for (int times = 0; times < 10; ++times) {
      vehicle.lose(lost);
      vehicle.second();
      vehicle.lose({});
      vehicle.seconds(2);
    }
    EXPECT_EQ(vehicle.starts, 1) << lost;
    EXPECT_EQ(vehicle.plan, "glidercc") << lost;
    EXPECT_EQ(vehicle.toldDepth(), 20) << lost;
    EXPECT_EQ(vehicle.renewed, 0) << lost;
    vehicle.temperature = 10;
    vehicle.seconds(3);
    EXPECT_EQ(vehicle.toldDepth(), 40) << lost;
  }
}

TEST(ImcBackseat, GarbageBetweenPacketsIsCountedAndSkipped) {
  TwoDepths mission;
  ImcVehicle vehicle(mission.mission);
  begin(vehicle);
  EXPECT_EQ(vehicle.damaged(), 0U);
  vehicle.sayBytes({1, 2, 3, 4, 5});
  vehicle.seconds(3);
  EXPECT_EQ(vehicle.damaged(), 5U);
  EXPECT_EQ(vehicle.toldDepth(), 20);
}

TEST(ImcBackseat, AnothersPlanIsLeftAlone) {
  TwoDepths mission;
  ImcVehicle vehicle(mission.mission);
  vehicle.plan = "survey";
  for (int second = 0; second < 60; ++second) {
    vehicle.heard_s = vehicle.now_s;
    vehicle.second();
  }
  EXPECT_EQ(vehicle.starts, 0);
  EXPECT_EQ(vehicle.references, 0);
  EXPECT_EQ(vehicle.stops, 0);
  EXPECT_EQ(vehicle.context(), nullptr);
  vehicle.plan.reset();
  begin(vehicle);
}

TEST(ImcBackseat, AnothersPlanEndsOurs) {
  for (const bool stopped : {false, true}) {
    TwoDepths mission;
    ImcVehicle vehicle(mission.mission);
    begin(vehicle);
    const int told = vehicle.references;
    for (int second = 0; second < 120; ++second) {
      vehicle.plan = stopped ? std::nullopt : std::optional<std::string>("survey");
      vehicle.heard_s = vehicle.now_s;
      vehicle.second();
    }
    EXPECT_EQ(vehicle.starts, 1) << stopped;
    EXPECT_EQ(vehicle.stops, 0) << stopped;
    EXPECT_LE(vehicle.references, told + 1) << stopped;
    EXPECT_EQ(vehicle.plan, stopped ? std::nullopt : std::optional<std::string>("survey"));
  }
}

TEST(ImcBackseat, APlanLostUnderWaterIsStartedAgainAndTheMissionGoesOn) {
  TwoDepths mission;
  ImcVehicle vehicle(mission.mission);
  begin(vehicle);
  vehicle.depth_m = 18;
  vehicle.temperature = 10;
  vehicle.seconds(5);
  ASSERT_EQ(vehicle.toldDepth(), 40);
  vehicle.deaf = true;
  vehicle.seconds(17);
  EXPECT_EQ(vehicle.plan, std::nullopt);
  vehicle.deaf = false;
  vehicle.seconds(20);
  EXPECT_EQ(vehicle.plan, "glidercc");
  EXPECT_EQ(vehicle.toldDepth(), 40) << "the state that it was in";
  EXPECT_EQ(vehicle.count("mission,bench"), 1);
  EXPECT_EQ(vehicle.count("transition,"), 1);
}

TEST(ImcBackseat, WhatItSaidItselfIsNotTheVehicles) {
  TwoDepths mission;
  ImcVehicle vehicle(mission.mission);
  EstimatedState state;
  state.depth = 30;
  vehicle.say(state, kOwnAddress);
  vehicle.hand();
  begin(vehicle);
  for (const uint16_t source : {kOwnAddress, uint16_t{0x1F}}) {
    for (int second = 0; second < 5; ++second) {
      vehicle.lose({});
      vehicle.say(Temperature{.value = 5}, source);
      vehicle.say(testing::planState(PlanState::Ready), source);
      vehicle.lose(Temperature::kId);  // the newest is that of another
      vehicle.second();
    }
    vehicle.lose({});
    EXPECT_EQ(vehicle.toldDepth(), 20) << "a temperature of another";
    EXPECT_EQ(vehicle.plan, "glidercc");
    EXPECT_EQ(vehicle.starts, 1);
  }
}

TEST(ImcBackseat, StartsNothingOutOfTheWater) {
  TwoDepths mission;
  ImcVehicle vehicle(mission.mission);
  for (const uint8_t medium : {Medium::OnGround, Medium::InAir, Medium::Unknown}) {
    vehicle.medium = medium;
    vehicle.seconds(20);
    EXPECT_EQ(vehicle.starts, 0) << int{medium};
  }
  vehicle.medium = Medium::WaterSurface;
  begin(vehicle);
}

TEST(ImcBackseat, StartsNothingWhileTwoVehiclesReport) {
  TwoDepths mission;
  ImcVehicle vehicle(mission.mission);
  vehicle.second();
  EstimatedState state;
  state.depth = 0.1F;
  vehicle.say(state, 0x00D2);
  vehicle.hand();
  vehicle.seconds(30);
  EXPECT_EQ(vehicle.starts, 0);
}

/// Whoever aborts: what flew is not started again.
TEST(ImcBackseat, IsTheOperatorsAfterAnAbort) {
  TwoDepths mission;
  ImcVehicle vehicle(mission.mission);
  begin(vehicle);
  vehicle.say(Abort{}, 0x4002);
  vehicle.hand();
  vehicle.plan.reset();
  vehicle.seconds(120);
  EXPECT_EQ(vehicle.starts, 1);
  EXPECT_EQ(vehicle.plan, std::nullopt);
}

TEST(ImcBackseat, SeveralStatesInASecondAreOneCycle) {
  TwoDepths mission;
  ImcVehicle vehicle(mission.mission);
  begin(vehicle);
  const int before = vehicle.heartbeats;
  EstimatedState state;
  state.lat = 0.72;
  state.lon = -0.15;
  for (int second = 0; second < 10; ++second) {
    vehicle.second();
    for (int more = 0; more < 4; ++more) {
      vehicle.say(state);
      vehicle.hand();
    }
  }
  EXPECT_EQ(vehicle.heartbeats, before + 10);
}

TEST(ImcBackseat, ADeafVehicleIsConnectedAgain) {
  TwoDepths mission;
  ImcVehicle vehicle(mission.mission);
  begin(vehicle);
  vehicle.lose(FollowRefState::kId);
  vehicle.seconds(5);
  EXPECT_EQ(vehicle.renewed, 0);
  vehicle.seconds(2);
  EXPECT_GE(vehicle.renewed, 1);
  vehicle.lose({});
  vehicle.seconds(1);
  const int renewed = vehicle.renewed;
  vehicle.seconds(30);
  EXPECT_EQ(vehicle.renewed, renewed);
  EXPECT_EQ(vehicle.toldDepth(), 20);
}

/// While nothing was received an operator may have started a plan, which a start would replace.
TEST(ImcBackseat, StartsNothingOnANewConnectionBeforeThePlanIsKnown) {
  for (const bool by_itself : {false, true}) {
    TwoDepths mission;
    ImcVehicle vehicle(mission.mission);
    askInVain(vehicle);
    if (by_itself) {
      drop(vehicle, 60);
    } else {
      for (int second = 0; second < 20 && vehicle.renewed == 0; ++second) {
        vehicle.second();
      }
      ASSERT_EQ(vehicle.renewed, 1);
    }
    vehicle.deaf = false;
    vehicle.plan = "survey";
    vehicle.heard_s = vehicle.now_s + 100;
    for (int cycle = 0; cycle < 8; ++cycle) {
      vehicle.say(VehicleMedium{.medium = Medium::WaterSurface});
      sayState(vehicle);
    }
    vehicle.seconds(8);
    EXPECT_EQ(vehicle.starts, 0) << by_itself;
    EXPECT_EQ(vehicle.plan, "survey") << by_itself;
    vehicle.plan.reset();
    vehicle.seconds(12);
    EXPECT_EQ(vehicle.starts, 1) << by_itself;
    EXPECT_EQ(vehicle.toldDepth(), 20) << by_itself;
  }
}

/// The report behind the state that completes the cycle was taken from the line with it, wherever
/// the reads have cut the bytes.
TEST(ImcBackseat, StartsNothingBeforeAllThatHasArrivedWasTaken) {
  for (size_t before = 0; before < 64; ++before) {
    TwoDepths mission;
    ImcVehicle vehicle(mission.mission);
    vehicle.lose(PlanControlState::kId);
    vehicle.seconds(2);
    vehicle.lose({});
    vehicle.now_s += 1;
    vehicle.say(testing::planState(PlanState::Ready, ""));
    vehicle.sayBytes(std::vector<uint8_t>(before, 0));
    vehicle.say(stateNow());
    vehicle.plan = "survey";
    vehicle.heard_s = vehicle.now_s;
    vehicle.say(testing::planState(PlanState::Executing, "s"));
    vehicle.hand();
    EXPECT_EQ(vehicle.starts, 0) << before;
  }
}

TEST(ImcBackseat, AConnectionIsNotInDoubtForWhatWasSentOnTheLastOne) {
  for (const bool of_start : {false, true}) {
    TwoDepths mission;
    ImcVehicle vehicle(mission.mission);
    if (of_start) {
      askInVain(vehicle);
    } else {
      begin(vehicle);
      vehicle.temperature = 10;
      vehicle.deaf = true;
      vehicle.second();
    }
    drop(vehicle, 6);
    vehicle.deaf = false;
    const int references = vehicle.references;
    vehicle.second();
    EXPECT_EQ(vehicle.renewed, 0) << of_start;
    EXPECT_EQ(of_start ? vehicle.starts : vehicle.references - references, 1) << of_start;
  }
}

/// It may have been lifted out of the water meanwhile.
TEST(ImcBackseat, StartsNothingOnANewConnectionBeforeTheMediumIsKnown) {
  TwoDepths mission;
  ImcVehicle vehicle(mission.mission);
  askInVain(vehicle);
  drop(vehicle, 60);
  vehicle.deaf = false;
  for (int cycle = 0; cycle < 8; ++cycle) {
    vehicle.say(testing::planState(PlanState::Ready, ""));
    sayState(vehicle);
  }
  EXPECT_EQ(vehicle.starts, 0);
  vehicle.seconds(1);
  EXPECT_EQ(vehicle.starts, 1);
}

/// A request to stop does not name a plan: it would end the operator's.
TEST(ImcBackseat, StopsNothingOnANewConnectionBeforeThePlanIsKnown) {
  int around_the_drop = 0;
  for (const double end_s : {8, 9, 10, 11, 12, 13, 14, 15, 16}) {
    TwoDepths mission;
    mission.end_s = end_s;
    ImcVehicle vehicle(mission.mission);
    vehicle.seconds(11);
    const int stops = vehicle.stops;
    drop(vehicle, 60);
    vehicle.plan = "survey";
    for (int cycle = 0; cycle < 5; ++cycle) {
      sayState(vehicle);
    }
    EXPECT_EQ(vehicle.stops, stops) << end_s;
    around_the_drop += stops == 0 ? 1 : 0;
    vehicle.heard_s = vehicle.now_s + 100;
    vehicle.seconds(8);
    EXPECT_EQ(vehicle.stops, stops) << end_s;
    EXPECT_EQ(vehicle.plan, "survey") << end_s;
    EXPECT_TRUE(vehicle.finished) << end_s;
  }
  EXPECT_GT(around_the_drop, 0);
}

/// The end comes although the line drops while it is asked for.
TEST(ImcBackseat, TheEndIsAskedForOnTheNextConnection) {
  TwoDepths mission;
  mission.end_s = 20;
  ImcVehicle vehicle(mission.mission);
  begin(vehicle);
  vehicle.deaf = true;
  vehicle.seconds(9);
  drop(vehicle, 1);
  vehicle.deaf = false;
  sayState(vehicle);
  EXPECT_EQ(vehicle.stops, 0);
  EXPECT_EQ(vehicle.plan, "glidercc");
  vehicle.seconds(10);
  EXPECT_TRUE(vehicle.finished);
  EXPECT_GE(vehicle.stops, 1);
  EXPECT_EQ(vehicle.plan, std::nullopt);
}

/// Each packet that the vehicle gets has the time of its clock.
TEST(ImcBackseat, WhatWaitsToBeSentEndsWithItsConnection) {
  TwoDepths mission;
  ImcVehicle vehicle(mission.mission);
  begin(vehicle);
  vehicle.stuck = true;
  vehicle.seconds(2);
  vehicle.closed = true;
  vehicle.seconds(3);
  vehicle.stuck = vehicle.closed = false;
  const int references = vehicle.references;
  vehicle.seconds(2);
  EXPECT_EQ(vehicle.references, references + 2);
  EXPECT_EQ(vehicle.toldDepth(), 20);
}

TEST(ImcBackseat, ALineWithoutRoomIsConnectedAgain) {
  TwoDepths mission;
  ImcVehicle vehicle(mission.mission);
  begin(vehicle);
  vehicle.stuck = true;
  vehicle.seconds(5);
  EXPECT_EQ(vehicle.renewed, 0);
  vehicle.seconds(2);
  EXPECT_EQ(vehicle.renewed, 1);
}

TEST(ImcBackseat, ADepthBeyondTheVehiclesIsNeverSent) {
  TwoDepths mission;
  ImcVehicle vehicle(mission.mission, testing::imcOf(30));
  begin(vehicle);
  vehicle.temperature = 10;
  for (int second = 0; second < 30; ++second) {
    vehicle.second();
    EXPECT_LE(vehicle.toldDepth(), 30);
  }
}

TEST(ImcBackseat, OnlyASimulatedVehicleIsToldTheState) {
  for (const bool simulated : {false, true}) {
    TwoDepths mission;
    ImcVehicle vehicle(mission.mission);
    if (simulated) {
      Announce announce;
      announce.sys_name = textOf("lauv");
      announce.services = textOf("glidercc+virtual-time");
      vehicle.say(announce);
    }
    vehicle.seconds(20);
    EXPECT_EQ(vehicle.count("state,") > 0, simulated);
  }
}

}  // namespace
}  // namespace glider::runtime::imc
