// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// A serial line that is silent for a while has no end of a connection that would be noticed: what
// the vehicle reported before does not count after it (runtime/imc/README.md, M2).

#include "tests/unit/runtime/imc_vehicle.h"

namespace glider::runtime::imc {
namespace {

using namespace hooks::imc;
using testing::ImcVehicle;
using testing::TwoDepths;

void stateAlone(ImcVehicle& vehicle) {
  vehicle.now_s += 1;
  EstimatedState state;
  state.lat = 0.72;
  state.lon = -0.15;
  state.depth = 0.2F;
  state.alt = -1;
  vehicle.say(state);
  vehicle.hand();
}

/// A vehicle at a serial line.
struct SerialVehicle : ImcVehicle {
  explicit SerialVehicle(const GliderMission& mission)
      : ImcVehicle(mission, testing::imcOf(), false) {}
};

/// Ready at the surface, and asked for the start, which it did not read.
void reportOnce(ImcVehicle& vehicle) {
  vehicle.seconds(1);
  vehicle.deaf = true;
  vehicle.seconds(2);
  vehicle.deaf = false;
  ASSERT_EQ(vehicle.starts, 0);
}

TEST(ImcSilence, AReportOfThePlanCountsForTenSeconds) {
  for (const double silent_s : {8.0, 10.0, 3600.0}) {
    TwoDepths mission;
    SerialVehicle vehicle(mission.mission);
    reportOnce(vehicle);
    vehicle.now_s += silent_s - 1;
    vehicle.plan = "survey";
    vehicle.say(VehicleMedium{.medium = Medium::WaterSurface});
    stateAlone(vehicle);
    EXPECT_EQ(vehicle.starts, silent_s < 10 ? 1 : 0) << silent_s;
  }
}

TEST(ImcSilence, StartsNothingWhileOnlyThePlanIsNotReported) {
  TwoDepths mission;
  SerialVehicle vehicle(mission.mission);
  reportOnce(vehicle);
  vehicle.deaf = true;
  vehicle.lose(PlanControlState::kId);
  vehicle.seconds(20);
  vehicle.deaf = false;
  vehicle.seconds(10);
  EXPECT_EQ(vehicle.starts, 0);
  vehicle.lose({});
  vehicle.seconds(8);
  EXPECT_EQ(vehicle.starts, 1);
}

/// It may have been lifted out of the water meanwhile.
TEST(ImcSilence, StartsNothingBeforeTheMediumIsKnownAgain) {
  TwoDepths mission;
  SerialVehicle vehicle(mission.mission);
  reportOnce(vehicle);
  vehicle.now_s += 10;
  for (int cycle = 0; cycle < 8; ++cycle) {
    vehicle.say(testing::planState(PlanState::Ready, ""));
    stateAlone(vehicle);
  }
  EXPECT_EQ(vehicle.starts, 0);
  vehicle.seconds(1);
  EXPECT_EQ(vehicle.starts, 1);
}

/// A request to stop does not name a plan: it would end the operator's.
TEST(ImcSilence, StopsNothingBeforeThePlanIsKnownAgain) {
  int after_the_silence = 0;
  for (const double end_s : {8, 9, 10, 11, 12, 13, 14, 15, 16}) {
    TwoDepths mission;
    mission.end_s = end_s;
    SerialVehicle vehicle(mission.mission);
    vehicle.seconds(11);
    const int stops = vehicle.stops;
    vehicle.now_s += 60;
    vehicle.plan = "survey";
    for (int cycle = 0; cycle < 5; ++cycle) {
      stateAlone(vehicle);
    }
    EXPECT_EQ(vehicle.stops, stops) << end_s;
    after_the_silence += stops == 0 ? 1 : 0;
    vehicle.heard_s = vehicle.now_s + 100;
    vehicle.seconds(8);
    EXPECT_EQ(vehicle.stops, stops) << end_s;
    EXPECT_EQ(vehicle.plan, "survey") << end_s;
    EXPECT_TRUE(vehicle.finished) << end_s;
  }
  EXPECT_GT(after_the_silence, 0);
}

TEST(ImcSilence, AClockThatIsSetBackLeavesNothingKnownForLong) {
  TwoDepths mission;
  SerialVehicle vehicle(mission.mission);
  reportOnce(vehicle);
  vehicle.now_s -= 3600;
  vehicle.plan = "survey";
  for (int cycle = 0; cycle < 8; ++cycle) {
    vehicle.say(VehicleMedium{.medium = Medium::WaterSurface});
    stateAlone(vehicle);
  }
  EXPECT_EQ(vehicle.starts, 0);
}

}  // namespace
}  // namespace glider::runtime::imc
