// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/hookbeh/hull.h"
#include "tests/unit/hooks/hookbeh_bench.h"

#include <gtest/gtest.h>

namespace glider::hooks {
namespace {

using Bench = HookbehBench;
constexpr double kInfinite = std::numeric_limits<double>::infinity();

Bench ready(const HookbehArgs& args) {
  Bench bench(args);
  bench.cycle();
  return bench;
}

TEST(HookbehHull, IsThatOfThePlatformFile) {
  EXPECT_EQ(kHull.greatest_depth_m, 200);
  EXPECT_EQ(kHull.steepest_pitch_rad, 0.7854);
  EXPECT_EQ(kHull.shallowest_pitch_rad, 0.19);
  EXPECT_EQ(kHull.vertical_rate_m_s, 0.4);
  EXPECT_EQ(kHull.pump_cc, 233);
  EXPECT_EQ(kHull.fin_rad, 0.45);
  EXPECT_EQ(kHull.battery_in, 0.6);
}

TEST(HookbehHull, NoArgDivesDeeperThanTheHull) {
  for (const double wild : {201.0, 1e9, kInfinite}) {
    HookbehArgs args;
    args.greatest_depth_m = wild;
    Bench bench = ready(args);
    EXPECT_EQ(bench.give(Bench::take(201)).answer, HookAnswer::TooDeep) << wild;
    EXPECT_EQ(bench.give(Bench::take(200)).answer, HookAnswer::Accepted) << wild;
    bench.inputs.depth_m = 200.5;
    EXPECT_EQ(bench.cycle().guard, HookGuard::TooDeep) << wild;
  }
}

TEST(HookbehHull, NoArgPitchesSteeperOrFlatterThanTheHull) {
  HookbehArgs args;
  args.steepest_pitch_rad = 1e9;
  args.shallowest_pitch_rad = -1e9;
  Bench bench = ready(args);
  Instruction steep = Bench::take(20);
  steep.pitch_rad = -0.79;
  EXPECT_EQ(bench.give(steep).answer, HookAnswer::BadPitch);
  steep.pitch_rad = -0.18;
  EXPECT_EQ(bench.give(steep).answer, HookAnswer::BadPitch);
  steep.pitch_rad = -0.78;
  EXPECT_EQ(bench.give(steep).answer, HookAnswer::Accepted);
}

TEST(HookbehHull, PitchesThatContradictEachOtherStayInTheHull) {
  HookbehArgs args;
  args.steepest_pitch_rad = -3;
  args.shallowest_pitch_rad = 3;
  const HookbehArgs narrowed = within(args, kHull);
  EXPECT_EQ(narrowed.steepest_pitch_rad, 0.19);
  EXPECT_EQ(narrowed.shallowest_pitch_rad, 0.7854);
  Bench bench = ready(args);
  bench.give(Bench::vertical(HookVertical::Surface));
  EXPECT_EQ(bench.give(Bench::take(20)).answer, HookAnswer::BadPitch) << "none is right";
}

TEST(HookbehHull, APumpWithTheWrongSignIsTurnedRound) {
  HookbehArgs args;
  args.dive_pump_cc = 200;
  args.climb_pump_cc = -210;
  Bench bench = ready(args);
  EXPECT_EQ(bench.give(Bench::take(20)).pump_cc, -200);
  EXPECT_EQ(bench.give(Bench::ascend(5)).pump_cc, 210);
  bench.inputs.depth_m = 31;
  EXPECT_EQ(bench.cycle().pump_cc, kHull.pump_cc) << "the guard has all of it";
}

TEST(HookbehHull, AutoballastUsesTheWholeStroke) {
  HookbehArgs args;
  args.dive_pump_mode = args.climb_pump_mode = PumpMode::Autoballast;
  args.dive_pump_cc = -20;
  args.climb_pump_cc = 150;
  Bench bench = ready(args);
  EXPECT_EQ(bench.give(Bench::take(20)).pump_cc, -kHull.pump_cc);
  EXPECT_EQ(bench.give(Bench::ascend(5)).pump_cc, kHull.pump_cc);
  args.dive_pump_mode = static_cast<PumpMode>(1);  // a code that hookbeh does not have
  bench = ready(args);
  EXPECT_EQ(bench.give(Bench::take(20)).pump_cc, -20);
}

TEST(HookbehHull, NoPumpGoesBeyondItsStrokeNorIsTooWeakToClimb) {
  HookbehArgs args;
  args.dive_pump_cc = -1000;
  args.climb_pump_cc = 0;
  Bench bench = ready(args);
  EXPECT_EQ(bench.give(Bench::take(20)).pump_cc, -233);
  EXPECT_EQ(bench.give(Bench::ascend(5)).pump_cc, 116.5);
  args.climb_pump_cc = 1000;
  EXPECT_EQ(within(args, kHull).climb_pump_cc, 233);
}

TEST(HookbehHull, NoArgHoldsTheFinFartherThanTheHull) {
  const auto narrowed = [](double wild, double hull_rad = kHull.fin_rad) {
    HookbehArgs args;
    args.greatest_fin_rad = wild;
    Hull hull = kHull;
    hull.fin_rad = hull_rad;
    return within(args, hull).greatest_fin_rad;
  };
  EXPECT_EQ(narrowed(0.46), 0.45);
  EXPECT_EQ(narrowed(kInfinite), 0.45);
  EXPECT_EQ(narrowed(0.2), 0.2);
  EXPECT_EQ(narrowed(-0.2), 0);
  EXPECT_EQ(narrowed(kNan), 0.45) << "the default";
  EXPECT_EQ(narrowed(kNan, 0.3), 0.3);
  EXPECT_EQ(narrowed(0.2, 0), 0) << "a vehicle without a fin";
}

TEST(HookbehHull, NoArgMovesPumpOrBatteryFartherThanTheHull) {
  const auto narrowed = [](double wild, const Hull& hull = kHull) {
    HookbehArgs args;
    args.greatest_pump_cc = args.greatest_battery_in = wild;
    return within(args, hull);
  };
  for (const double wild : {300.0, kInfinite}) {
    EXPECT_EQ(narrowed(wild).greatest_pump_cc, 233);
    EXPECT_EQ(narrowed(wild).greatest_battery_in, 0.6);
  }
  EXPECT_EQ(narrowed(0.5).greatest_pump_cc, 0.5);
  EXPECT_EQ(narrowed(0.5).greatest_battery_in, 0.5);
  EXPECT_EQ(narrowed(-1).greatest_pump_cc, 0);
  EXPECT_EQ(narrowed(-1).greatest_battery_in, 0);
  EXPECT_EQ(narrowed(kNan).greatest_pump_cc, 233) << "the default";
  EXPECT_EQ(narrowed(kNan).greatest_battery_in, 0.6);
  Hull small = kHull;
  small.pump_cc = 100;
  small.battery_in = 0;
  EXPECT_EQ(narrowed(kNan, small).greatest_pump_cc, 100);
  EXPECT_EQ(narrowed(0.5, small).greatest_battery_in, 0) << "a vehicle without a pitch battery";
}

TEST(HookbehHull, NoAltitudeIsBelowTheRangeOfTheAltimeter) {
  HookbehArgs args;
  args.least_altitude_m = 0.1;
  EXPECT_EQ(within(args, kHull).least_altitude_m, 2);
  args.least_altitude_m = -1;
  EXPECT_EQ(within(args, kHull).least_altitude_m, -1) << "no altimeter is used";
}

TEST(HookbehHull, NoSbcIsWaitedForForEver) {
  for (const double wild : {1e9, kInfinite}) {
    HookbehArgs args;
    args.silence_secs = wild;
    Bench bench = ready(args);
    bench.give(Bench::vertical(HookVertical::Surface));
    Instruction surface = Bench::vertical(HookVertical::Surface);
    surface.control = HookControl::Take;
    bench.give(surface);
    bench.alive = false;
    int cycles = 0;
    while (bench.cycle().state == HookState::Active && cycles < 1000) {
      ++cycles;
    }
    EXPECT_EQ(cycles, 149) << "ten minutes";
  }
}

TEST(HookbehHull, NarrowerArgsCount) {
  const HookbehArgs usual;
  const HookbehArgs same = within(usual, kHull);
  EXPECT_EQ(same.greatest_depth_m, usual.greatest_depth_m);
  EXPECT_EQ(same.least_altitude_m, usual.least_altitude_m);
  EXPECT_EQ(same.steepest_pitch_rad, usual.steepest_pitch_rad);
  EXPECT_EQ(same.shallowest_pitch_rad, usual.shallowest_pitch_rad);
  EXPECT_EQ(same.greatest_fin_rad, usual.greatest_fin_rad);
  EXPECT_EQ(same.greatest_pump_cc, usual.greatest_pump_cc);
  EXPECT_EQ(same.greatest_battery_in, usual.greatest_battery_in);
  EXPECT_EQ(same.silence_secs, usual.silence_secs);
  EXPECT_EQ(same.dive_pump_cc, usual.dive_pump_cc);
  EXPECT_EQ(same.climb_pump_cc, usual.climb_pump_cc);
}

}  // namespace
}  // namespace glider::hooks
