// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// A REMUS that does not obey a request has that in the mission log: runtime/recon/README.md, N18.

#include "tests/unit/runtime/recon_vehicle.h"

#include <gmock/gmock.h>

namespace glider::runtime::recon {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using testing::ReconVehicle;
using ::testing::SizeIs;
using testing::TwoDepths;

constexpr const char* kInVain = "request without effect on the vehicle";

TEST(ReconRefusals, AnOverrideThatIsNotGivenIsLoggedOnceAndThenOnceAMinute) {
  TwoDepths mission;
  ReconVehicle vehicle(mission.mission);
  vehicle.deaf_to_begin = true;
  while (vehicle.asks < 10 && vehicle.now_s < 1.7e9 + 100) {
    vehicle.second();
  }
  EXPECT_THAT(vehicle.logged(kInVain), IsEmpty()) << "some may be lost";
  vehicle.seconds(50);
  EXPECT_THAT(vehicle.logged(kInVain),
              ElementsAre("0,event,request without effect on the vehicle,10,override,"));
  vehicle.seconds(60);
  ASSERT_THAT(vehicle.logged(kInVain), SizeIs(2));
  EXPECT_EQ(vehicle.logged(kInVain)[1],
            "0,event,request without effect on the vehicle,60,override,");
  vehicle.deaf_to_begin = false;
  vehicle.seconds(200);
  EXPECT_NE(vehicle.context(), nullptr);
  EXPECT_LE(vehicle.logged(kInVain).size(), 3U);
}

TEST(ReconRefusals, AnOverrideThatDoesNotEndIsLogged) {
  TwoDepths mission;
  mission.end_s = 30;
  ReconVehicle vehicle(mission.mission);
  vehicle.deaf_to_end = true;
  for (int second = 0; second < 300 && !vehicle.finished; ++second) {
    vehicle.second();
  }
  EXPECT_TRUE(vehicle.finished);
  ASSERT_THAT(vehicle.logged(kInVain), SizeIs(1));
  EXPECT_TRUE(vehicle.logged(kInVain)[0].ends_with(",10,end of the override,"));
}

TEST(ReconRefusals, AFlightToItsEndRefusesNothing) {
  TwoDepths mission;
  mission.end_s = 30;
  ReconVehicle vehicle(mission.mission);
  vehicle.seconds(100);
  EXPECT_TRUE(vehicle.finished);
  EXPECT_THAT(vehicle.logged(kInVain), IsEmpty());
}

/// A request that is lost now and then has an effect later: the count begins again.
TEST(ReconRefusals, RequestsThatAreObeyedBeginAnew) {
  TwoDepths mission;
  ReconVehicle vehicle(mission.mission);
  for (int turn = 0; turn < 10; ++turn) {
    vehicle.deaf_to_begin = true;
    vehicle.seconds(6);
    vehicle.deaf_to_begin = false;
    vehicle.seconds(10);
    vehicle.now_s += 6;  // without a state
    vehicle.mode = hooks::recon::Mode::Launched;
  }
  EXPECT_GE(vehicle.asks, 20);
  EXPECT_THAT(vehicle.logged(kInVain), IsEmpty());
}

}  // namespace
}  // namespace glider::runtime::recon
