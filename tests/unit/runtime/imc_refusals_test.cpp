// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What a vehicle that is steered by IMC refuses is in the mission log: runtime/imc/README.md, M13.

#include "tests/unit/runtime/imc_vehicle.h"

#include <gmock/gmock.h>

namespace glider::runtime::imc {
namespace {

using namespace hooks::imc;
using ::testing::ElementsAre;
using testing::ImcVehicle;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using testing::TwoDepths;

constexpr const char* kRefused = "request refused by the vehicle";
constexpr const char* kError = "error in the vehicle's plan";

bool saysNothing(const ImcVehicle& vehicle) {
  return vehicle.logged(kRefused).empty() && vehicle.logged(kError).empty();
}

TEST(ImcRefusals, ARefusedStartIsLoggedOnceAndThenOnceAMinute) {
  TwoDepths mission;
  ImcVehicle vehicle(mission.mission);
  vehicle.refuses = true;
  vehicle.seconds(60);
  ASSERT_GE(vehicle.starts, 8) << "it is asked again";
  EXPECT_THAT(vehicle.logged(kRefused),
              ElementsAre("0,event,request refused by the vehicle,1,start of the plan,"));
  vehicle.seconds(30);
  EXPECT_THAT(vehicle.logged(kRefused), SizeIs(2));
  EXPECT_EQ(vehicle.logged(kRefused)[1],
            "0,event,request refused by the vehicle,10,start of the plan,");
  vehicle.refuses = false;
  vehicle.seconds(12);
  EXPECT_NE(vehicle.context(), nullptr);
  EXPECT_THAT(vehicle.logged(kError), IsEmpty());
}

TEST(ImcRefusals, AFlightToItsEndRefusesNothing) {
  TwoDepths mission;
  mission.end_s = 30;
  ImcVehicle vehicle(mission.mission);
  vehicle.seconds(5);
  vehicle.reply(PlanControlType::Success);
  vehicle.seconds(60);
  EXPECT_TRUE(vehicle.finished);
  EXPECT_TRUE(saysNothing(vehicle));
}

TEST(ImcRefusals, AnEndThatIsRefusedWhileThePlanRunsIsLogged) {
  for (const bool runs : {false, true}) {
    TwoDepths mission;
    mission.end_s = 30;
    ImcVehicle vehicle(mission.mission);
    vehicle.seconds(20);
    ASSERT_EQ(vehicle.plan, "glidercc");
    vehicle.refuses = true;
    while (vehicle.stops == 0 && vehicle.now_s < 1.7e9 + 100) {
      vehicle.second();
    }
    if (!runs) {
      vehicle.plan.reset();  // it had ended: DUNE answers that none runs
    }
    vehicle.seconds(10);
    EXPECT_TRUE(vehicle.finished);
    EXPECT_THAT(vehicle.logged(kRefused), SizeIs(runs ? 1 : 0));
    EXPECT_TRUE(!runs || vehicle.logged(kRefused)[0].ends_with(",1,end of the plan,"));
  }
}

TEST(ImcRefusals, APlanThatEndsWithAnErrorIsLogged) {
  TwoDepths mission;
  ImcVehicle vehicle(mission.mission);
  vehicle.seconds(20);
  ASSERT_EQ(vehicle.plan, "glidercc");
  vehicle.reply(PlanControlType::Failure);
  vehicle.plan.reset();
  vehicle.seconds(3);
  ASSERT_THAT(vehicle.logged(kError), SizeIs(1));
  EXPECT_TRUE(vehicle.logged(kError)[0].ends_with(",1,,")) << vehicle.logged(kError)[0];
  EXPECT_FALSE(vehicle.logged(kError)[0].starts_with("0,")) << "at the mission's time";
  EXPECT_THAT(vehicle.logged(kRefused), IsEmpty());
}

TEST(ImcRefusals, ARefusalToStartAPlanAgainIsNoErrorOfTheOldOne) {
  TwoDepths mission;
  ImcVehicle vehicle(mission.mission);
  vehicle.seconds(20);
  vehicle.deaf = true;
  while (vehicle.plan && vehicle.now_s < 1.7e9 + 100) {
    vehicle.second();
  }
  vehicle.deaf = false;
  vehicle.refuses = true;
  vehicle.seconds(20);
  EXPECT_THAT(vehicle.logged(kRefused), SizeIs(1));
  EXPECT_THAT(vehicle.logged(kError), IsEmpty());
}

TEST(ImcRefusals, RepliesToOthersDoNotCount) {
  TwoDepths mission;
  ImcVehicle vehicle(mission.mission);
  vehicle.seconds(20);
  vehicle.reply(PlanControlType::Failure, 0x4002);
  vehicle.second();
  vehicle.reply(PlanControlType::InProgress);
  vehicle.second();
  --vehicle.request_id;
  vehicle.reply(PlanControlType::Failure);
  vehicle.second();
  EXPECT_TRUE(saysNothing(vehicle));
}

}  // namespace
}  // namespace glider::runtime::imc
