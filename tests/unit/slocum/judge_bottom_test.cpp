// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The check of contacts with the bottom and of the clearance over it.

#include "tests/unit/slocum/good_flight.h"
#include "vehicles/slocum/oracles/newest_echo.h"

namespace glider::slocum::oracles {
namespace {

/// Contacts of a vehicle whose altimeter receives nothing.
class JudgedContacts : public testing::Test {
 protected:
  JudgedContacts() {
    setup_.promise = promiseOf(FaultKind::SensorMissing);
    setup_.faults.sensors.push_back({.name = "m_altitude", .kind = SensorFault::Kind::Missing});
  }
  std::string touch(double east_m, double water_m, double seconds = kCycle) {
    std::string wrong;
    for (double passed = 0; passed < seconds && wrong.empty(); passed += kCycle) {
      wrong = cycle(east_m, water_m, 0);
    }
    const std::string left = cycle(east_m, water_m, 20);
    return wrong.empty() ? left : wrong;
  }
  void flyClear(double seconds) {
    for (double passed = 0; passed < seconds; passed += kCycle) {
      (void)cycle(0, 40, 20);
    }
  }
  std::string cycle(double east_m, double water_m, double clearance_m) {
    now_ += kCycle;
    array_.set(GLIDER_M_DEPTH, water_m - clearance_m + reading_error_m_);
    CycleView view{now_, hook_, water_m - clearance_m, false, false, array_, now_, clearance_m};
    view.east_m = east_m;
    return judge_.cycle(view);
  }
  /// Three echoes in water of that depth.
  void receiveThree(double east_m, double water_m, double clearance_m) {
    for (int i = 0; i < 3; ++i) {
      array_.beginCycle();
      array_.set(GLIDER_M_ALTITUDE, clearance_m + 0.1 * i);
      EXPECT_EQ(cycle(east_m, water_m, clearance_m), "");
    }
    array_.beginCycle();
  }
  JudgeSetup setup_ = GoodFlight::usual();
  BottomJudge judge_{setup_};
  SensorArray array_{shippedSetup("default").platform};
  HookState hook_ = HookState::Active;
  double now_ = 0, reading_error_m_ = 0;
};

TEST_F(JudgedContacts, TheFirstIsOfABottomThatNobodyKnew) {
  EXPECT_EQ(touch(0, 40, 200), "");
  EXPECT_EQ(touch(3001, 40), "") << "another place";
}

TEST_F(JudgedContacts, TheSecondAtAPlaceIsSeen) {
  EXPECT_EQ(touch(0, 40, 60), "");
  EXPECT_EQ(touch(300, 40), "the vehicle is on the bottom again, 300 m from an earlier contact");
}

TEST_F(JudgedContacts, TheFourthShortContactAtAPlaceIsSeen) {
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(touch(100 * i, 40, 44), "") << i;
  }
  EXPECT_EQ(touch(300, 40), "the vehicle has touched the bottom 4 times here");
  EXPECT_EQ(touch(3400, 40), "") << "another place";
}

TEST_F(JudgedContacts, ShortOnesOverAShallowBottomAreNotCounted) {
  for (int i = 0; i < 6; ++i) {
    EXPECT_EQ(touch(100 * i, 12, 44), "") << i;
  }
}

/// Rare echoes are enough for hookbeh only.
TEST_F(JudgedContacts, OfTheVehiclesOwnBehavioursAreNotHookbehs) {
  setup_.faults.sensors.clear();
  setup_.echo_every_s = 80;
  receiveThree(0, 40, 20);
  hook_ = HookState::Complete;
  EXPECT_EQ(touch(0, 40), "the vehicle is on the bottom") << "it may still be on its way";
  flyClear(60);
  EXPECT_EQ(touch(500, 40), "");
  setup_.echo_every_s = 4;
  EXPECT_EQ(touch(1000, 40), "the vehicle is on the bottom");
}

TEST_F(JudgedContacts, WhereTheBottomHasRisenItIsNotKnown) {
  EXPECT_EQ(touch(0, 40, 60), "");
  EXPECT_EQ(touch(300, 35, 60), "");
  EXPECT_NE(touch(400, 34), "");
}

TEST_F(JudgedContacts, OverAShallowBottomAreForgotten) {
  EXPECT_EQ(touch(0, 11, 60), "");
  flyClear(1000);
  EXPECT_NE(touch(0, 11), "");
  flyClear(1900);
  EXPECT_EQ(touch(0, 11), "");
}

TEST_F(JudgedContacts, RareEchoesShowTheBottomAfterThree) {
  setup_.faults.sensors.clear();
  setup_.echo_every_s = 80;
  EXPECT_EQ(touch(0, 40), "");
  receiveThree(3500, 40, 20);
  EXPECT_EQ(touch(7000, 40), "the vehicle is on the bottom");
}

TEST_F(JudgedContacts, AfterALongSilenceRareEchoesShowNoBottom) {
  setup_.faults.sensors.clear();
  setup_.echo_every_s = 80;
  for (const double silent_s : {600.0, 700.0}) {
    judge_.restart();
    receiveThree(0, 40, 20);
    flyClear(silent_s);
    EXPECT_EQ(touch(0, 40).empty(), silent_s > 640) << silent_s;
  }
  for (const double surface_s : {1000.0, 1204.0}) {
    array_.set(GLIDER_M_ALTITUDE, 20 + surface_s / 1e4);
    EXPECT_EQ(cycle(0, 40, 20), "");
    array_.beginCycle();
    now_ += surface_s;
    EXPECT_EQ(cycle(0, 42, 40), "");
    EXPECT_EQ(touch(9 * surface_s, 40).empty(), surface_s > 1200) << surface_s;
  }
}

/// Over so shallow a bottom hookbeh forgets an echo after ten minutes.
TEST_F(JudgedContacts, RareEchoesDoNotShowAShallowBottom) {
  setup_.faults.sensors.clear();
  setup_.echo_every_s = 80;
  receiveThree(0, 11, 8);
  EXPECT_EQ(touch(0, 11), "");
  EXPECT_EQ(touch(0, 13.5), "the vehicle is on the bottom");
}

/// Between rare echoes the vehicle may come nearer than min_altitude, between usual ones not.
TEST_F(JudgedContacts, RareEchoesPromiseNoClearance) {
  setup_.faults.sensors.clear();
  setup_.promise = promiseOf(FaultKind::None);
  for (const double every_s : {80.0, 4.0}) {
    setup_.echo_every_s = every_s;
    BottomJudge judge(setup_);
    std::string wrong;
    for (const double clearance_m : {20.0, 20.1, 20.2, 20.3, 0.7}) {
      now_ += kCycle;
      array_.beginCycle();
      array_.set(GLIDER_M_ALTITUDE, clearance_m);
      array_.set(GLIDER_M_DEPTH, 40 - clearance_m);
      wrong = judge.cycle({now_, hook_, 40 - clearance_m, false, false, array_, now_, clearance_m});
    }
    EXPECT_EQ(wrong.empty(), every_s > 20) << wrong;
  }
}

TEST_F(JudgedContacts, AContactThatDoesNotEndIsSeen) {
  EXPECT_EQ(touch(0, 40, 700), "the vehicle has been on the bottom for 604 s");
}

TEST_F(JudgedContacts, AVehicleThatKnowsNoDepthCannotAvoidThem) {
  EXPECT_EQ(touch(0, 40), "");
  reading_error_m_ = 5;
  EXPECT_EQ(touch(10, 40), "");
}

TEST_F(JudgedContacts, ANewHookbehKnowsNoPlace) {
  EXPECT_EQ(touch(0, 40), "");
  judge_.restart();
  EXPECT_EQ(touch(10, 40), "");
}

TEST_F(JudgedContacts, AnAltimeterThatHearsAgainAvoidsAll) {
  setup_.faults.sensors.front().when.to_s = 100;
  now_ = 100 + 590;
  EXPECT_EQ(touch(0, 40), "") << "what it reported still counts";
  now_ = 100 + 601;
  EXPECT_EQ(touch(8000, 40), "the vehicle is on the bottom");
}

TEST(NewestEcho, IsNotWhatHookbehKnowsATouchedBottomBy) {
  SensorArray array(shippedSetup("default").platform);
  NewestEcho echo;
  EXPECT_GT(echo.age(), 1e9);
  array.set(GLIDER_M_ALTITUDE, 20);
  echo.cycle({100, HookState::Active, 20, false, false, array, 100, 20});
  array.beginCycle();
  echo.cycle({112, HookState::Active, 39, false, false, array, 112, 1});
  EXPECT_EQ(echo.age(), 12);
  EXPECT_EQ(echo.ageOfWhatHookbehKnows(), 12);
  echo.cycle({116, HookState::Active, 40, false, false, array, 116, 0});
  EXPECT_EQ(echo.age(), 16);
  EXPECT_GT(echo.ageOfWhatHookbehKnows(), 1e9);
}

}  // namespace
}  // namespace glider::slocum::oracles
