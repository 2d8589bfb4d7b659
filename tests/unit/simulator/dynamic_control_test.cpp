// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/slocum/flight/dynamic_control.h"

#include "tests/unit/simulator/slocum_vehicle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

/// Pitch servo, heading autopilot and pump, in numbers computed by hand.
namespace glider::simulator {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kPi = std::numbers::pi;
constexpr double kCycle = 4;
using Pitch = PitchCommand::Mode;
using Heading = HeadingCommand::Mode;

/// A vehicle at the surface under a dynamic control; where its motors go when they have time to.
class Bench {
 public:
  void cycle(const PitchCommand& pitch, const HeadingCommand& heading, double pump,
             DynamicControl::Measured measured) {
    Commands commands;
    commands.point(pitch);
    commands.steer(heading);
    commands.pump(pump);
    control.cycle(commands, measured, kCycle, vehicle_);
  }
  double battery(const PitchCommand& pitch, double time_s, double measured) {
    cycle(pitch, {}, 0, {time_s, measured, 0, 0});
    return settled().batteryPositionIn();
  }
  double fin(const HeadingCommand& heading, double measured, double bearing = 0) {
    cycle({Pitch::BatteryPosition, 0}, heading, 0, {0, 0, measured, bearing});
    return settled().fin();
  }
  double pump(double cc) {
    cycle({Pitch::BatteryPosition, 0}, {}, cc, {0, 0, 0, 0});
    return settled().pumpedCc();
  }

  DynamicControl control;

 private:
  const Vehicle& settled() {
    OceanSettings settings;
    settings.density = 1025;
    const Ocean ocean(settings);
    for (int i = 0; i < 200; ++i) {
      vehicle_.step(ocean, i * Vehicle::kStep);
    }
    return vehicle_;
  }
  Vehicle vehicle_ = slocumVehicle();
};

TEST(DynamicControl, BatteryPositionGoesToTheMotorAsItIs) {
  Bench bench;
  EXPECT_NEAR(bench.battery({Pitch::BatteryPosition, 0.31}, 0, 0), 0.31, 1e-12);
  EXPECT_TRUE(std::isnan(bench.control.pitchCommand()));
  EXPECT_NEAR(bench.battery({Pitch::BatteryPosition, -0.31}, 100, 0.5), -0.31, 1e-12);
  EXPECT_NEAR(bench.battery({Pitch::BatteryPosition, -0.31}, 200, 0.5), -0.31, 1e-12) << "no servo";
  EXPECT_EQ(bench.battery({Pitch::BatteryPosition, 2}, 300, 0), 1.425);
  EXPECT_EQ(bench.battery({Pitch::BatteryPosition, -2}, 400, 0), -1.425);
}

TEST(DynamicControl, TheCurveIsTheVendors) {
  // pitch = -1.2565 rad/in * position + 0.055 rad
  Bench bench;
  EXPECT_NEAR(bench.battery({Pitch::Curve, -0.4538}, 0, 0), 0.5088 / 1.2565, 1e-12);
  EXPECT_EQ(bench.control.pitchCommand(), -0.4538);
  EXPECT_NEAR(bench.battery({Pitch::Curve, 0.4538}, 4, 0), -0.3988 / 1.2565, 1e-12);
  EXPECT_NEAR(bench.battery({Pitch::Curve, 0.4538}, 100, 0), -0.3988 / 1.2565, 1e-12) << "once";
}

TEST(DynamicControl, TheServoJudgesAfter24SecondsAndThenEvery16) {
  Bench bench;
  const PitchCommand dive{Pitch::Servo, -0.4538};
  const double first = 0.5088 / 1.2565;
  EXPECT_NEAR(bench.battery(dive, 100, 0), first, 1e-12);
  EXPECT_NEAR(bench.battery(dive, 123, -0.3538), first, 1e-12) << "the hull still swings";
  // Too flat by 0.1 rad: 1.5 in/rad forward.
  EXPECT_NEAR(bench.battery(dive, 124, -0.3538), first + 0.15, 1e-12);
  EXPECT_NEAR(bench.battery(dive, 139, -0.3538), first + 0.15, 1e-12);
  EXPECT_NEAR(bench.battery(dive, 140, -0.3538), first + 0.3, 1e-12);
  // Too steep by 0.06 rad: back.
  EXPECT_NEAR(bench.battery(dive, 156, -0.5138), first + 0.21, 1e-12);
  EXPECT_EQ(bench.control.pitchCommand(), -0.4538);
}

TEST(DynamicControl, TheServoHasADeadbandAndALargestStep) {
  Bench bench;
  const PitchCommand climb{Pitch::Servo, 0.4538};
  const double first = -0.3988 / 1.2565;
  EXPECT_NEAR(bench.battery(climb, 0, 0), first, 1e-12);
  EXPECT_NEAR(bench.battery(climb, 24, 0.4538 - 0.0523), first, 1e-12);
  EXPECT_NEAR(bench.battery(climb, 40, 0.4538 + 0.0523), first, 1e-12);
  EXPECT_NEAR(bench.battery(climb, 56, 0.4538 - 0.0525), first - 1.5 * 0.0525, 1e-12);
  EXPECT_NEAR(bench.battery(climb, 72, 0.4538 + 0.0525), first, 1e-12);
  EXPECT_NEAR(bench.battery(climb, 88, 0), first - 0.2, 1e-12) << "at most 0.2 in";
  EXPECT_NEAR(bench.battery(climb, 104, 1), first, 1e-12);
  for (int i = 0; i < 20; ++i) {
    (void)bench.battery(climb, 120 + 16 * i, -0.4);
  }
  EXPECT_EQ(bench.battery(climb, 1000, -0.4), -1.425) << "the stop of the motor";
  EXPECT_NEAR(bench.battery(climb, 1016, 1), -1.225, 1e-12) << "and back from it at once";
}

TEST(DynamicControl, ANewCommandBeginsWithTheCurveAgain) {
  Bench bench;
  (void)bench.battery({Pitch::Servo, -0.4538}, 0, 0);
  (void)bench.battery({Pitch::Servo, -0.4538}, 24, -0.3);
  EXPECT_NEAR(bench.battery({Pitch::Servo, 0.4}, 28, -0.4), -0.345 / 1.2565, 1e-12);
  EXPECT_NEAR(bench.battery({Pitch::Servo, 0.4}, 48, -0.4), -0.345 / 1.2565, 1e-12);
  EXPECT_NEAR(bench.battery({Pitch::Servo, 0.4}, 52, 0.3), -0.345 / 1.2565 - 0.15, 1e-12);
}

TEST(DynamicControl, AnUnknownPitchMovesNothing) {
  Bench bench;
  (void)bench.battery({Pitch::Servo, -0.4538}, 0, 0);
  EXPECT_NEAR(bench.battery({Pitch::Servo, -0.4538}, 24, kNaN), 0.5088 / 1.2565, 1e-12);
}

TEST(DynamicControl, TheFinIsAShareOfItsRange) {
  // 1.5 per rad beyond 0.087 rad, in shares of 0.45 rad; positive turns to starboard.
  EXPECT_NEAR(Bench().fin({Heading::Heading, 1.2}, 1.0), 0.45 * 0.3, 1e-12);
  EXPECT_NEAR(Bench().fin({Heading::Heading, 1.0}, 1.2), -0.45 * 0.3, 1e-12);
  EXPECT_EQ(Bench().fin({Heading::Heading, 1.0}, 1.0869), 0);
  EXPECT_EQ(Bench().fin({Heading::Heading, 1.0}, 0.9131), 0);
  EXPECT_NEAR(Bench().fin({Heading::Heading, 1.0}, 0.9129), 0.45 * 1.5 * 0.0871, 1e-12);
  EXPECT_NEAR(Bench().fin({Heading::Heading, 3}, 1.0), 0.45, 1e-12) << "all of it";
  EXPECT_NEAR(Bench().fin({Heading::Heading, 1}, 3), -0.45, 1e-12);
}

TEST(DynamicControl, TurnsTheShortWay) {
  EXPECT_NEAR(Bench().fin({Heading::Heading, 0.1}, 2 * kPi - 0.1), 0.45 * 0.3, 1e-12);
  EXPECT_NEAR(Bench().fin({Heading::Heading, 2 * kPi - 0.1}, 0.1), -0.45 * 0.3, 1e-12);
  EXPECT_NEAR(Bench().fin({Heading::Heading, -kPi / 2}, 3 * kPi / 2), 0, 1e-12);
}

TEST(DynamicControl, TheTurnIsDamped) {
  Bench bench;
  (void)bench.fin({Heading::Heading, 1.5}, 1.0);
  // 0.08 rad in 4 s: 4 per rad/s of 0.02 are taken off the 1.5 * 0.42.
  EXPECT_NEAR(bench.fin({Heading::Heading, 1.5}, 1.08), 0.45 * (0.63 - 0.08), 1e-12);
  EXPECT_NEAR(bench.fin({Heading::Heading, 1.08}, 1.16), -0.45 * 0.08, 1e-12) << "in the deadband";
  (void)bench.fin({Heading::Heading, 1.5}, kNaN);
  EXPECT_NEAR(bench.fin({Heading::Heading, 1.5}, 1.3), 0.45 * 0.3, 1e-12) << "no rate yet";
  EXPECT_NEAR(bench.fin({Heading::Heading, 1.5}, 1.3), 0.45 * 0.3, 1e-12);
}

TEST(DynamicControl, TheRateGoesThroughNorth) {
  Bench bench;
  (void)bench.fin({Heading::Heading, 0.3}, 2 * kPi - 0.04);
  EXPECT_NEAR(bench.fin({Heading::Heading, 0.3}, 0.04), 0.45 * (1.5 * 0.26 - 0.08), 1e-12);
}

TEST(DynamicControl, SteersToTheBearingOfAWaypoint) {
  Bench bench;
  EXPECT_NEAR(bench.fin({Heading::Waypoint, 9, 3910, -7350}, 1.0, 1.2), 0.45 * 0.3, 1e-12);
  EXPECT_EQ(bench.control.headingCommand(), 1.2);
  EXPECT_EQ(Bench().fin({Heading::Waypoint, 9, 3910, -7350}, 1.0, kNaN), 0) << "straight on";
  EXPECT_EQ(Bench().fin({Heading::Heading, 2}, kNaN), 0);
}

TEST(DynamicControl, AFixedFinIsHeld) {
  Bench bench;
  EXPECT_NEAR(bench.fin({Heading::Fin, 0.2}, 1.0), 0.2, 1e-12);
  EXPECT_TRUE(std::isnan(bench.control.headingCommand()));
  (void)bench.fin({Heading::Heading, 2}, 1.0);
  EXPECT_EQ(bench.control.headingCommand(), 2);
}

TEST(DynamicControl, ThePumpKeepsToItsLimits) {
  Bench bench;
  EXPECT_EQ(bench.pump(100), 100);
  EXPECT_EQ(bench.pump(1000), 233);
  EXPECT_EQ(bench.control.pumpCommand(), 233);
  EXPECT_EQ(bench.pump(-1000), -233);
  EXPECT_EQ(bench.control.pumpCommand(), -233);
}

/// A vehicle whose motors move as fast as the platform says, under a dynamic control.
class Turning : public testing::Test {
 protected:
  Turning() {
    OceanSettings settings;
    settings.density = 1025;
    ocean_.emplace(settings);
  }
  void command(double battery, double pump, bool at_once = false) {
    commands_ = {};
    commands_.point({Pitch::BatteryPosition, battery});
    commands_.steer({});
    commands_.pump(pump);
    commands_.at_once = at_once;
  }
  /// Until the motors rest.
  void settle() { cycles(10); }
  void cycles(int count) {
    for (int i = 0; i < count; ++i) {
      control_.cycle(commands_, {time_, 0, 0, 0}, kCycle, vehicle_);
      for (int step = 0; step < kCycle / Vehicle::kStep; ++step) {
        vehicle_.step(*ocean_, time_ + step * Vehicle::kStep);
      }
      time_ += kCycle;
    }
  }
  [[nodiscard]] double pump() const { return vehicle_.pumpedCc(); }
  [[nodiscard]] double battery() const { return vehicle_.batteryPositionIn(); }

  std::optional<Ocean> ocean_;
  DynamicControl control_;
  Vehicle vehicle_ = slocumVehicle();
  Commands commands_;
  double time_ = 0;
};

/// 466 cc at 37.5 cc/s: 12.4 s, so 4 cycles until it is seen.
constexpr int kStroke = 4;

TEST_F(Turning, TheBallastMovesFirstWhereTheBatteryHelpsToClimb) {
  command(0.4, -233), settle();
  command(-0.4, 233), cycles(kStroke);
  EXPECT_EQ(pump(), 233);
  EXPECT_EQ(battery(), 0.4) << "it waits for the ballast";
  cycles(2);
  EXPECT_NEAR(battery(), -0.4, 0.05);
}

TEST_F(Turning, TheBallastMovesFirstWhereTheBatteryHelpsToDive) {
  command(-0.4, 233), settle();
  command(0.4, -233), cycles(kStroke);
  EXPECT_EQ(pump(), -233);
  EXPECT_EQ(battery(), -0.4);
  cycles(2);
  EXPECT_NEAR(battery(), 0.4, 0.05);
}

TEST_F(Turning, TheBatteryMovesFirstWhereItWorksAgainstTheTurn) {
  command(-0.2, -233), settle();
  command(0.2, 233), cycles(1);
  EXPECT_GT(battery(), -0.2);
  EXPECT_EQ(pump(), -233) << "a climb with the battery forward";
  settle();
  EXPECT_EQ(pump(), 233);
  EXPECT_EQ(battery(), 0.2);
}

TEST_F(Turning, OtherCommandsWaitUntilItIsOver) {
  command(0.4, -233), settle();
  command(-0.4, 233), cycles(1);
  command(0.4, -233), cycles(kStroke - 1);
  EXPECT_EQ(pump(), 233);
  cycles(2);
  EXPECT_NEAR(battery(), -0.4, 0.05) << "the turn that had begun";
  cycles(8);
  EXPECT_EQ(pump(), -233);
  EXPECT_NEAR(battery(), 0.4, 0.05);
}

TEST_F(Turning, AnAbortWaitsForNothing) {
  command(-0.4, 233), settle();
  command(0.4, -233), cycles(1);
  command(-0.4, 233, true), cycles(4);
  EXPECT_EQ(pump(), 233);
  EXPECT_EQ(battery(), -0.4);
}

TEST_F(Turning, SmallMovesOfThePumpAreNoInflection) {
  command(0.4, -100), settle();
  command(-0.4, 100), cycles(1);
  EXPECT_GT(pump(), -100);
  EXPECT_LT(battery(), 0.4) << "both at once: less than half of the pump's range";
}

TEST_F(Turning, TheServoWaitsForTheHull) {
  command(0.4, -233), settle();
  commands_.point({Pitch::Servo, 0.4538});
  commands_.pump(233);
  cycles(kStroke + 2);
  const double begins = battery();
  EXPECT_NEAR(begins, -0.3988 / 1.2565, 0.05) << "the vendor's curve";
  cycles(3);
  EXPECT_NEAR(battery(), begins, 0.05) << "12 s";
  cycles(3);
  EXPECT_LT(battery(), begins - 0.1) << "the measured pitch is 0: nose up";
}

}  // namespace
}  // namespace glider::simulator
