// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What wakes a sleeping SBC, in the vehicle's units, from what the mission's code says in SI units.

#include "hooks/protocol/nap.h"
#include "runtime/abi/glider_abi.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace glider::runtime {
namespace {

using hooks::NapKind;

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
constexpr double kEndless = std::numeric_limits<double>::infinity();

constexpr double kAhead_m = 16;

double pollNothing(double /*mission_time*/) {
  return kUnknown;
}

class Foreseen : public ::testing::Test {
 protected:
  Foreseen() {
    mission_.sensors = sensors_.data();
    mission_.sensor_count = static_cast<uint32_t>(sensors_.size());
    mission_.naps = &naps_;
    context_.mission = &mission_;
    context_.readings = readings_.data();
    context_.mission_time = 1000;
    nap_.seconds = 240;
    nap_.wakes = wakes_;
  }

  void reads(uint32_t sensor, double raw, double value, double updated = 1000) {
    readings_[sensor] = {raw, updated, value, 1, 0};
  }
  /// The one value of a kind for a sensor's number; NaN: there is none.
  double valueOf(uint32_t id, NapKind kind) const {
    double found = kUnknown;
    for (uint32_t i = 0; i < nap_.count; ++i) {
      if (wakes_[i].sensor == id && wakes_[i].kind == static_cast<uint32_t>(kind)) {
        EXPECT_TRUE(std::isnan(found)) << "twice";
        found = wakes_[i].value;
      }
    }
    return found;
  }
  void crossed(uint32_t sensor, double number) {
    gliderNapCrossed(&nap_, &context_, sensor, number);
  }
  void lost(uint32_t sensor) { gliderNapLost(&nap_, &context_, sensor); }

  // Depth in m, a pressure in bar, a position, one of the SBC's own.
  std::vector<GliderSensorInfo> sensors_{
      {"depth", nullptr, 1, -2, 1200, 20, 7, kGliderLinear},
      {"pressure", nullptr, 1e5, -kEndless, 120, 20, 9, kGliderLinear},
      {"lat", nullptr, 1, -9000, 9000, 20, 11, kGliderDegreesMinutes},
      {"own", pollNothing, 1, -2, 1200, 20, 0xFF00, kGliderLinear}};
  std::vector<GliderReading> readings_ = std::vector<GliderReading>(4, {0, 0, kUnknown, 0, 0});
  GliderNaps naps_{240, kAhead_m, 0, 10, 0, 0, nullptr};
  GliderMission mission_{};
  GliderContext context_{};
  GliderWake wakes_[GLIDER_MOST_WAKES] = {};
  GliderNap nap_{};
};

TEST_F(Foreseen, ANumberIsPassedFromTheSideOnWhichTheReadingIs) {
  reads(0, 20, 20);
  crossed(0, 50);
  crossed(0, 5);
  EXPECT_EQ(nap_.count, 2U);
  EXPECT_EQ(valueOf(7, NapKind::AtLeast), 50);
  EXPECT_EQ(valueOf(7, NapKind::AtMost), 5);
  EXPECT_EQ(nap_.awake, 0U);
}

TEST_F(Foreseen, TheNearestNumberOnEachSideCounts) {
  reads(0, 20, 20);
  for (const double number : {50.0, 30.0, 40.0, 5.0, 15.0, 10.0}) {
    crossed(0, number);
  }
  EXPECT_EQ(nap_.count, 2U);
  EXPECT_EQ(valueOf(7, NapKind::AtLeast), 30);
  EXPECT_EQ(valueOf(7, NapKind::AtMost), 15);
}

/// The vehicle would hover there until the SBC is awake.
TEST_F(Foreseen, ADepthThatItIsOnItsWayToWakesAhead) {
  reads(0, 20, 20);
  context_.depth = 50;
  context_.vertical = kGliderDescend;
  crossed(0, 50);
  crossed(0, 3);
  EXPECT_EQ(valueOf(7, NapKind::AtLeast), 50 - kAhead_m);
  EXPECT_EQ(valueOf(7, NapKind::AtMost), 3);
  EXPECT_EQ(nap_.awake, 0U);
  nap_.count = 0;
  context_.depth = 3;
  context_.vertical = kGliderAscend;
  crossed(0, 50);
  crossed(0, 3);
  EXPECT_EQ(valueOf(7, NapKind::AtLeast), 50);
  EXPECT_EQ(valueOf(7, NapKind::AtMost), 3 + kAhead_m);
  EXPECT_EQ(nap_.awake, 0U);
}

TEST_F(Foreseen, NoSleepWhereItIsNearADepthThatItIsOnItsWayTo) {
  context_.depth = 50;
  context_.vertical = kGliderDescend;
  for (const auto& [depth, awake] : {std::pair(33.9, 0U), {34.0, 1U}, {49.0, 1U}}) {
    nap_.awake = 0;
    reads(0, depth, depth);
    crossed(0, 50);
    EXPECT_EQ(nap_.awake, awake) << depth;
  }
  context_.depth = 3;
  context_.vertical = kGliderAscend;
  for (const auto& [depth, awake] : {std::pair(19.1, 0U), {19.0, 1U}, {4.0, 1U}}) {
    nap_.awake = 0;
    reads(0, depth, depth);
    crossed(0, 3);
    EXPECT_EQ(nap_.awake, awake) << depth;
  }
}

/// It does not go beyond its target, nor anywhere while it hovers; and only its depth is meant.
TEST_F(Foreseen, NumbersThatItIsNotOnItsWayToDoNotWakeAhead) {
  context_.depth = 50;
  context_.vertical = kGliderDescend;
  reads(0, 20, 20);
  crossed(0, 51);
  EXPECT_EQ(valueOf(7, NapKind::AtLeast), 51);
  reads(1, 2, 2);
  crossed(1, 50);
  EXPECT_GT(valueOf(9, NapKind::AtLeast), 49e-5);
  context_.vertical = kGliderAscend;
  crossed(0, 19);
  EXPECT_EQ(valueOf(7, NapKind::AtMost), 19);
  for (const auto vertical : {kGliderHover, kGliderSurface, kGliderActuators, kGliderNoVertical}) {
    nap_.count = 0;
    context_.vertical = vertical;
    crossed(0, 50);
    crossed(0, 19);
    EXPECT_EQ(valueOf(7, NapKind::AtLeast), 50);
    EXPECT_EQ(valueOf(7, NapKind::AtMost), 19);
  }
  EXPECT_EQ(nap_.awake, 0U);
}

TEST_F(Foreseen, AReadingAtTheNumberIsLeftByAnyOther) {
  reads(0, 20, 20);
  crossed(0, 20);
  EXPECT_EQ(valueOf(7, NapKind::AtLeast), std::nextafter(20, 21));
  EXPECT_EQ(valueOf(7, NapKind::AtMost), std::nextafter(20, 19));
}

TEST_F(Foreseen, ZeroIsLeftByTheSmallestNumbers) {
  reads(0, 0, 0);
  crossed(0, 0);
  EXPECT_GT(valueOf(7, NapKind::AtLeast), 0);
  EXPECT_LT(valueOf(7, NapKind::AtMost), 0);
}

TEST_F(Foreseen, InTheUnitOfTheVehicleNeverLate) {
  reads(1, 2, 2e5);
  crossed(1, 3e5);
  crossed(1, 1e5);
  EXPECT_LE(valueOf(9, NapKind::AtLeast), 3);
  EXPECT_GT(valueOf(9, NapKind::AtLeast), 2.999999);
  EXPECT_GE(valueOf(9, NapKind::AtMost), 1);
  EXPECT_LT(valueOf(9, NapKind::AtMost), 1.000001);
}

TEST_F(Foreseen, AnUnknownNumberIsNeverPassed) {
  reads(0, 20, 20);
  crossed(0, kUnknown);
  EXPECT_EQ(nap_.count, 0U);
  EXPECT_EQ(nap_.awake, 0U);
}

TEST_F(Foreseen, AnUnknownReadingWakesWhenItIsKnown) {
  crossed(0, 50);
  gliderNapKnown(&nap_, &context_, 0);
  EXPECT_EQ(nap_.count, 1U);
  EXPECT_EQ(valueOf(7, NapKind::Known), 0);
}

TEST_F(Foreseen, AKnownReadingNeedNotBeHeard) {
  reads(0, 20, 20);
  gliderNapKnown(&nap_, &context_, 0);
  EXPECT_EQ(nap_.count, 0U);
}

TEST_F(Foreseen, AReadingIsLostBySilenceAndByValuesThatCannotBe) {
  reads(0, 20, 20, 996);
  lost(0);
  EXPECT_EQ(valueOf(7, NapKind::AtLeast), std::nextafter(1200, 1201));
  EXPECT_EQ(valueOf(7, NapKind::AtMost), std::nextafter(-2, -3));
  EXPECT_EQ(valueOf(7, NapKind::Quiet), 16);
}

TEST_F(Foreseen, ARangeWithoutAnEndHasNothingPastIt) {
  reads(1, 2, 2e5);
  lost(1);
  EXPECT_TRUE(std::isnan(valueOf(9, NapKind::AtMost)));
  EXPECT_EQ(valueOf(9, NapKind::AtLeast), std::nextafter(120, 121));
}

TEST_F(Foreseen, AnUnknownReadingIsNotLost) {
  lost(0);
  EXPECT_EQ(nap_.count, 0U);
}

TEST_F(Foreseen, NoSleepOverAReadingThatIsSoonTooOld) {
  reads(0, 20, 20, 987);
  lost(0);
  EXPECT_EQ(nap_.awake, 1U);
}

TEST_F(Foreseen, NoSleepOverWhatTheVehicleCannotCompare) {
  for (const uint32_t sensor : {2U, 3U}) {
    nap_.awake = 0;
    reads(sensor, 20, 20);
    crossed(sensor, 50);
    EXPECT_EQ(nap_.awake, 1U) << sensor;
  }
  nap_.awake = 0;
  lost(3);
  EXPECT_EQ(nap_.awake, 1U);
  nap_.awake = 0;
  gliderNapKnown(&nap_, &context_, 3);
  EXPECT_EQ(nap_.awake, 1U);
}

TEST_F(Foreseen, TheEarliestTimeCounts) {
  for (const double seconds : {500.0, 100.0, 200.0, -5.0, kUnknown}) {
    gliderNapUntil(&nap_, seconds);
  }
  EXPECT_EQ(nap_.seconds, 100);
  gliderNapUntil(&nap_, 0);
  EXPECT_EQ(nap_.seconds, 0);
}

TEST_F(Foreseen, NoSleepWithMoreCausesThanThereIsRoomFor) {
  std::vector<GliderSensorInfo> many;
  for (uint32_t i = 0; i < 12; ++i) {
    many.push_back({"s", nullptr, 1, -10, 10, 20, i, kGliderLinear});
  }
  std::vector<GliderReading> readings(12, {0, 1000, 0, 1, 0});
  mission_.sensors = many.data();
  context_.readings = readings.data();
  for (uint32_t i = 0; i < 10; ++i) {
    lost(i);
    EXPECT_EQ(nap_.awake, 0U) << i;
  }
  lost(10);
  EXPECT_EQ(nap_.awake, 1U);
  EXPECT_EQ(nap_.count, GLIDER_MOST_WAKES);
}

}  // namespace
}  // namespace glider::runtime
