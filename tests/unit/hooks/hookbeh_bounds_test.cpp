// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/hookbeh/bounds.h"
#include "tests/unit/hooks/hookbeh_bench.h"

#include <gtest/gtest.h>

namespace glider::hooks {
namespace {

using Bench = HookbehBench;

HookAnswer answerTo(const Instruction& instruction, const HookbehArgs& args = {}) {
  Instruction carried;
  hookInSteps(&instruction, &carried);
  return hookbehCheckBounds(&carried, &args);
}

TEST(HookbehBounds, DepthUpToTheGreatest) {
  HookbehArgs args;
  args.greatest_depth_m = 30.1;  // no float32: 30.1F is larger
  EXPECT_EQ(answerTo(Bench::descend(30.1), args), HookAnswer::Accepted);
  EXPECT_EQ(answerTo(Bench::descend(30.2), args), HookAnswer::TooDeep);
  EXPECT_EQ(answerTo(Bench::ascend(30.2), args), HookAnswer::TooDeep);
  EXPECT_EQ(answerTo(Bench::vertical(HookVertical::Hover, 30.2), args), HookAnswer::TooDeep);
  EXPECT_EQ(answerTo(Bench::descend(-1)), HookAnswer::BadCommand);
  EXPECT_EQ(answerTo(Bench::descend(kNan)), HookAnswer::BadCommand);
  EXPECT_EQ(answerTo(Bench::vertical(HookVertical::Hover, kNan)), HookAnswer::BadCommand);
  args.greatest_depth_m = kNan;
  EXPECT_EQ(answerTo(Bench::descend(5), args), HookAnswer::TooDeep);
}

TEST(HookbehBounds, PitchInItsDirectionAndBetweenTheLimits) {
  auto descendAt = [](double pitch) {
    Instruction instruction = Bench::descend(20);
    instruction.pitch_rad = pitch;
    return answerTo(instruction);
  };
  auto ascendAt = [](double pitch) {
    Instruction instruction = Bench::ascend(5);
    instruction.pitch_rad = pitch;
    return answerTo(instruction);
  };
  EXPECT_EQ(descendAt(-0.61), HookAnswer::Accepted);
  EXPECT_EQ(descendAt(-0.19), HookAnswer::Accepted);
  EXPECT_EQ(descendAt(-0.62), HookAnswer::BadPitch);
  EXPECT_EQ(descendAt(-0.18), HookAnswer::BadPitch);
  EXPECT_EQ(descendAt(0.4), HookAnswer::BadPitch);
  EXPECT_EQ(descendAt(kNan), HookAnswer::BadPitch);
  EXPECT_EQ(ascendAt(0.61), HookAnswer::Accepted);
  EXPECT_EQ(ascendAt(0.19), HookAnswer::Accepted);
  EXPECT_EQ(ascendAt(0.62), HookAnswer::BadPitch);
  EXPECT_EQ(ascendAt(-0.4), HookAnswer::BadPitch);
}

TEST(HookbehBounds, UnusedNumbersAreNotLookedAt) {
  Instruction instruction = Bench::vertical(HookVertical::Surface, 1e9);
  instruction.pitch_rad = kNan;
  instruction.heading_rad = kNan;
  instruction.latitude_ddmm = kNan;
  EXPECT_EQ(answerTo(instruction), HookAnswer::Accepted);
}

TEST(HookbehBounds, HeadingWithinACircle) {
  auto heading = [](double value) {
    Instruction instruction = Bench::descend(20);
    instruction.lateral = HookLateral::Heading;
    instruction.heading_rad = value;
    return answerTo(instruction);
  };
  EXPECT_EQ(heading(0), HookAnswer::Accepted);
  EXPECT_EQ(heading(6.283185307179586), HookAnswer::Accepted);
  EXPECT_EQ(heading(-3.14), HookAnswer::Accepted);
  EXPECT_EQ(heading(7), HookAnswer::BadCommand);
  EXPECT_EQ(heading(kNan), HookAnswer::BadCommand);
}

TEST(HookbehBounds, FinUpToTheFarthest) {
  const auto fin = [](double angle, const HookbehArgs& args = {}) {
    Instruction instruction = Bench::descend(20);
    instruction.lateral = HookLateral::Fin;
    instruction.heading_rad = angle;
    return answerTo(instruction, args);
  };
  HookbehArgs args;
  args.greatest_fin_rad = 0.3;  // no float32: 0.3F is larger
  for (const double side : {-1.0, 1.0}) {
    EXPECT_EQ(fin(side * 0.45), HookAnswer::Accepted) << side;
    EXPECT_EQ(fin(side * 0.4501), HookAnswer::BadFin) << side;
    EXPECT_EQ(fin(side * 0.3, args), HookAnswer::Accepted) << side;
    EXPECT_EQ(fin(side * 0.3001, args), HookAnswer::BadFin) << side;
    EXPECT_EQ(fin(side * 6.283185307179586), HookAnswer::BadFin) << "a full turn is not 0";
    EXPECT_EQ(fin(side * 1e300), HookAnswer::BadFin) << side;
  }
  EXPECT_EQ(fin(0), HookAnswer::Accepted);
  EXPECT_EQ(fin(kNan), HookAnswer::BadFin);
  args.greatest_fin_rad = 0;
  EXPECT_EQ(fin(0, args), HookAnswer::Accepted);
  EXPECT_EQ(fin(0.01, args), HookAnswer::BadFin) << "no fin";
}

TEST(HookbehBounds, PumpAndBatteryUpToTheFarthest) {
  const auto moved = [](double pump_cc, double battery_in, const HookbehArgs& args = {}) {
    return answerTo(Bench::actuators(pump_cc, battery_in), args);
  };
  HookbehArgs args;
  args.greatest_pump_cc = 100.1;  // no float32, as 0.3
  args.greatest_battery_in = 0.3;
  for (const double side : {-1.0, 1.0}) {
    EXPECT_EQ(moved(side * 233, -side * 0.6), HookAnswer::Accepted) << side;
    EXPECT_EQ(moved(side * 233.1, 0), HookAnswer::BadPump) << side;
    EXPECT_EQ(moved(0, side * 0.601), HookAnswer::BadBattery) << side;
    EXPECT_EQ(moved(side * 100.1, side * 0.3, args), HookAnswer::Accepted) << side;
    EXPECT_EQ(moved(side * 100.2, 0, args), HookAnswer::BadPump) << side;
    EXPECT_EQ(moved(0, side * 0.301, args), HookAnswer::BadBattery) << side;
    EXPECT_EQ(moved(side * 1e300, 0), HookAnswer::BadPump) << side;
  }
  EXPECT_EQ(moved(kNan, 0), HookAnswer::BadPump);
  EXPECT_EQ(moved(0, kNan), HookAnswer::BadBattery);
  args.greatest_pump_cc = args.greatest_battery_in = 0;
  EXPECT_EQ(moved(0, 0, args), HookAnswer::Accepted);
  EXPECT_EQ(moved(1, 0, args), HookAnswer::BadPump);
  EXPECT_EQ(moved(0, 0.01, args), HookAnswer::BadBattery) << "no battery to command";
}

TEST(HookbehBounds, WaypointsOnEarth) {
  auto waypoint = [](double latitude, double longitude) {
    Instruction instruction = Bench::descend(20);
    instruction.lateral = HookLateral::Waypoint;
    instruction.latitude_ddmm = latitude;
    instruction.longitude_ddmm = longitude;
    return answerTo(instruction);
  };
  EXPECT_EQ(waypoint(3910.5, -7349.8058), HookAnswer::Accepted);
  EXPECT_EQ(waypoint(-9000, 18000), HookAnswer::Accepted);
  EXPECT_EQ(waypoint(3960, 0), HookAnswer::Accepted) << "rounded up from 59.99999999";
  EXPECT_EQ(waypoint(3961, 0), HookAnswer::NotOnEarth);
  EXPECT_EQ(waypoint(9000.1, 0), HookAnswer::NotOnEarth);
  EXPECT_EQ(waypoint(0, -18000.1), HookAnswer::NotOnEarth);
  EXPECT_EQ(waypoint(kNan, 0), HookAnswer::NotOnEarth);
  EXPECT_EQ(waypoint(0, 1e300), HookAnswer::NotOnEarth);
}

TEST(HookbehBounds, NoSuchCommand) {
  Bench bench;
  bench.cycle();
  bench.give(Bench::take(20));
  Instruction instruction = Bench::descend(20);
  instruction.control = static_cast<HookControl>(9);
  EXPECT_EQ(bench.give(instruction).answer, HookAnswer::BadCommand);
  instruction = Bench::descend(20);
  instruction.control = HookControl::None;
  EXPECT_EQ(bench.give(instruction).answer, HookAnswer::BadCommand);
  EXPECT_EQ(bench.give(Bench::vertical(static_cast<HookVertical>(6), 10)).answer,
            HookAnswer::BadCommand);
  instruction = Bench::descend(20);
  instruction.lateral = static_cast<HookLateral>(4);
  EXPECT_EQ(bench.give(instruction).answer, HookAnswer::BadCommand);
}

TEST(HookbehBounds, LimitsThatAFileRoundsRefuseNothingThatTheyAllow) {
  constexpr double kTwentySixDegrees = 0.4537856055185257;
  Instruction instruction;
  instruction.control = HookControl::Take;
  instruction.vertical = HookVertical::Descend;
  instruction.depth_m = 20;
  instruction.pitch_rad = -kTwentySixDegrees;
  HookbehArgs args;
  args.steepest_pitch_rad = 0.453786;
  EXPECT_EQ(answerTo(instruction, args), HookAnswer::Accepted);
  args.steepest_pitch_rad = 0.4537;
  EXPECT_EQ(answerTo(instruction, args), HookAnswer::BadPitch);
  args = {};
  args.shallowest_pitch_rad = 0.453793;
  EXPECT_EQ(answerTo(instruction, args), HookAnswer::Accepted);
  args.greatest_depth_m = 19.9996;
  EXPECT_EQ(answerTo(instruction, args), HookAnswer::Accepted);
  args.greatest_depth_m = 19.999;
  EXPECT_EQ(answerTo(instruction, args), HookAnswer::TooDeep);
}

}  // namespace
}  // namespace glider::hooks
