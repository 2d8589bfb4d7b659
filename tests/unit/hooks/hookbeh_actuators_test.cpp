// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// A commanded pump and pitch battery: what flies, and that every guard comes first.

#include "tests/unit/hooks/hookbeh_bench.h"

#include <gtest/gtest.h>

namespace glider::hooks {
namespace {

using Bench = HookbehBench;

/// In control at 10 m, under these actuators.
Bench moved(double pump_cc, double battery_in) {
  Bench bench;
  bench.cycle();
  bench.give(Bench::take(20));
  bench.give(Bench::actuators(pump_cc, battery_in));
  return bench;
}

void expectHeld(const HookbehOutputs& out, double pump_cc, double battery_in) {
  EXPECT_STREQ(wordsFor(out.doing), "pump and battery");
  EXPECT_EQ(out.pitch_mode, PitchMode::Battery);
  EXPECT_EQ(out.pump_cc, pump_cc);
  EXPECT_EQ(out.battery_in, battery_in);
  EXPECT_EQ(out.pitch_rad, 0) << "none is commanded";
  EXPECT_EQ(out.guard, HookGuard::None);
}

/// Each cycle of a climb by a guard.
void expectClimb(const HookbehOutputs& out, const char* doing) {
  EXPECT_STREQ(wordsFor(out.doing), doing);
  EXPECT_EQ(out.pitch_mode, PitchMode::Servo);
  EXPECT_EQ(out.pump_cc, kHull.pump_cc);
  EXPECT_GT(out.pitch_rad, 0);
  EXPECT_EQ(out.battery_in, 0);
}

TEST(HookbehActuators, AreHeldAsCommandedUntilTheNextInstruction) {
  Bench bench = moved(-150, 0.25);
  expectHeld(bench.cycle(), -150, 0.25);
  bench.inputs.depth_m = 14;
  expectHeld(bench.cycle(), -150, 0.25);
  expectHeld(bench.give(Bench::actuators(60, -0.5)), 60, -0.5);
  EXPECT_EQ(bench.give(Bench::actuators(240, 0)).answer, HookAnswer::BadPump);
  expectHeld(bench.cycle(), 60, -0.5);
  EXPECT_STREQ(wordsFor(bench.give(Bench::vertical(HookVertical::None)).doing), "pump and battery")
      << "a turn alone leaves them";
  const HookbehOutputs out = bench.give(Bench::ascend(5));
  EXPECT_STREQ(wordsFor(out.doing), "climb_to");
  EXPECT_EQ(out.pitch_mode, PitchMode::Servo);
  EXPECT_EQ(out.battery_in, 0);
}

TEST(HookbehActuators, MayBeginASession) {
  Bench bench;
  bench.cycle();
  Instruction take = Bench::actuators(-100, 0);
  take.control = HookControl::Take;
  expectHeld(bench.give(take), -100, 0);
}

TEST(HookbehActuators, TooDeepTheVehicleComesUp) {
  for (const double pump_cc : {-233.0, -20.0, 0.0, 200.0}) {
    Bench bench = moved(pump_cc, 0.5);
    bench.inputs.depth_m = 29.9;
    expectHeld(bench.cycle(), pump_cc, 0.5);
    bench.inputs.depth_m = 30.1;
    expectClimb(bench.cycle(), "climb: too deep");
    expectClimb(bench.give(Bench::actuators(-120, 0)), "climb: too deep");
    bench.inputs.depth_m = 20;
    expectClimb(bench.cycle(), "climb: too deep");
    bench.inputs.depth_m = 15.1;
    expectClimb(bench.cycle(), "climb: too deep");
    bench.inputs.depth_m = 15;
    expectHeld(bench.cycle(), -120, 0);
  }
}

TEST(HookbehActuators, NearTheBottomTheVehicleComesUp) {
  Bench bench = moved(-120, 0);
  bench.inputs.depth_m = 17.1;
  bench.inputs.altitude_m = 4.9;
  expectClimb(bench.cycle(), "climb: too near the bottom");
  bench.inputs.depth_m = 13;
  bench.inputs.altitude_m = 9;
  expectClimb(bench.cycle(), "climb: too near the bottom");
  bench.inputs.depth_m = 8.5;
  bench.inputs.altitude_m = 13.5;
  expectHeld(bench.cycle(), -120, 0);
  bench.inputs.depth_m = 15;
  bench.inputs.altitude_m = 7;
  bench.inputs.depth_rate_mps = 0.4;
  expectClimb(bench.cycle(), "climb: too near the bottom");
}

TEST(HookbehActuators, WithoutADepthTheVehicleComesUp) {
  Bench bench = moved(-120, 0);
  bench.raw_depth = true;
  bench.inputs.depth_m = kNan;
  expectClimb(bench.cycle(), "climb: depth unknown");
}

TEST(HookbehActuators, EndWithTheSbc) {
  Bench bench = moved(-120, 0);
  bench.alive = false;
  HookbehOutputs out;
  for (int i = 0; i < 7; ++i) {
    out = bench.cycle();
  }
  EXPECT_FALSE(out.commanding);
  EXPECT_EQ(out.state, HookState::Silent);
}

/// Seconds until something else flies, at most an hour, with a depth that only flickers.
double heldFor(double pump_cc, HookGuard* guard) {
  Bench bench = moved(pump_cc, 0);
  double seconds = 0;
  for (; seconds < 3600; seconds += 4) {
    bench.inputs.depth_m = 10 + (static_cast<int>(seconds) % 8 == 0 ? 0.01 : 0.02);
    const HookbehOutputs out = bench.cycle();
    *guard = out.guard;
    if (out.pitch_mode == PitchMode::Servo) {
      break;
    }
  }
  return seconds;
}

TEST(HookbehActuators, APumpThatIsFarInEndsLikeADiveThatGainsNoDepth) {
  for (const double pump_cc : {-100.0, -233.0}) {
    HookGuard guard = HookGuard::None;
    EXPECT_LE(heldFor(pump_cc, &guard), 184);
    EXPECT_EQ(guard, HookGuard::NoDepthGained);
  }
}

TEST(HookbehActuators, ATrimmedVehicleShowsItsDepthByAShortClimbLikeAHover) {
  for (const double pump_cc : {-99.0, 0.0, 233.0}) {
    HookGuard guard = HookGuard::NoDepthGained;
    const double seconds = heldFor(pump_cc, &guard);
    EXPECT_GE(seconds, 60) << pump_cc;
    EXPECT_LE(seconds, 620) << pump_cc;
    EXPECT_EQ(guard, HookGuard::None) << "no guard: it checks its depth";
  }
}

/// 200 cc are not a depth of 200 m, to which the vehicle would sink by itself.
TEST(HookbehActuators, DoNotEndAClimbThatGainsNoHeight) {
  Bench bench = moved(20, 0);
  HookbehOutputs out = bench.give(Bench::vertical(HookVertical::Surface));
  for (int i = 0; i < 70 && out.guard == HookGuard::None; ++i) {
    bench.inputs.depth_m = i % 2 == 0 ? 10.01 : 10.02;
    out = bench.cycle();
  }
  ASSERT_EQ(out.guard, HookGuard::NoHeightGained);
  expectClimb(bench.give(Bench::actuators(200, 0)), "climb: no height gained");
}

TEST(HookbehActuators, GoOnAfterACheckOfTheDepth) {
  Bench bench = moved(20, 0);
  HookbehOutputs out;
  int checks = 0;
  for (int i = 0; i < 900; ++i) {
    const double step_m = out.doing == Doing::CheckDepth ? -0.4 : 0.03;
    bench.inputs.depth_m = std::max(1.5, bench.inputs.depth_m + step_m);
    const Doing before = out.doing;
    out = bench.cycle();
    checks += before == Doing::CheckDepth && out.doing == Doing::Actuators ? 1 : 0;
    ASSERT_TRUE(out.doing == Doing::Actuators || out.doing == Doing::CheckDepth)
        << wordsFor(out.doing);
  }
  EXPECT_GE(checks, 2);
}

/// A battery at a fixed place may hold the nose down: the vehicle may sink faster than a level
/// hull.
TEST(HookbehActuators, ANoseThatMayBeDownIsCheckedSoonerThanAHover) {
  const auto cyclesTo = [](const Instruction& instruction) {
    Bench bench = moved(0, 0);
    bench.give(instruction);
    for (int i = 1; i < 600; ++i) {
      bench.inputs.depth_m = 20 + (i % 2 == 0 ? 0.01 : 0.02);
      if (bench.cycle().doing == Doing::CheckDepth) {
        return i;
      }
    }
    return 600;
  };
  const int trimmed = cyclesTo(Bench::actuators(-59, 0.6));
  Instruction hover = Bench::descend(20);
  hover.vertical = HookVertical::Hover;
  EXPECT_LT(trimmed, 0.8 * cyclesTo(hover));
}

/// There a climb can gain no height.
TEST(HookbehActuators, DiveAfterAClimbThatGainedNoHeightAtTheSurface) {
  Bench bench = moved(20, 0);
  Instruction up = Bench::vertical(HookVertical::Ascend);
  up.depth_m = 0.2;
  up.pitch_rad = 0.4;
  HookbehOutputs out = bench.give(up);
  for (int i = 0; i < 90 && out.guard == HookGuard::None; ++i) {
    bench.inputs.depth_m = i % 2 == 0 ? 0.6 : 0.61;  // it floats there: a swell, or an offset
    out = bench.cycle();
  }
  ASSERT_EQ(out.guard, HookGuard::NoHeightGained);
  out = bench.give(Bench::actuators(-200, 0));
  for (int i = 0; i < 5; ++i) {
    bench.inputs.depth_m = i % 2 == 0 ? 0.6 : 0.61;
    out = bench.cycle();
  }
  EXPECT_EQ(out.guard, HookGuard::None);
  EXPECT_EQ(out.doing, Doing::Actuators);
}

}  // namespace
}  // namespace glider::hooks
