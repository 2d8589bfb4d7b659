// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Hookbeh as a whole at its edges: what it counts, what it reads, and how it begins.

#include "hooks/hookbeh/bounds.h"
#include "hooks/hookbeh/hull.h"
#include "hooks/hookbeh/pilot.h"
#include "hooks/protocol/numbers.h"
#include "tests/unit/hooks/begun.h"
#include "tests/unit/hooks/hookbeh_bench.h"

#include <gtest/gtest.h>

namespace glider::hooks {
namespace {

using Bench = HookbehBench;

/// Active, under an SBC that is lost after `silence_secs`.
Bench taken(double silence_secs) {
  Bench bench(HookbehArgs{.silence_secs = silence_secs});
  bench.cycle();
  EXPECT_EQ(bench.give(Bench::take()).state, HookState::Active);
  return bench;
}

/// Cycles of 4 s in which it is still active; at most 100.
int activeFor(Bench& bench) {
  int cycles = 0;
  while (bench.cycle().state == HookState::Active && cycles < 100) {
    ++cycles;
  }
  return cycles;
}

TEST(HookbehCycleEdges, SilenceCountsFromTheLastBeat) {
  Bench bench = taken(21);
  for (int i = 0; i < 10; ++i) {
    bench.alive = i % 2 == 0;
    ASSERT_EQ(bench.cycle().state, HookState::Active) << i;
  }
  bench.alive = true;
  bench.cycle();
  bench.alive = false;
  EXPECT_EQ(activeFor(bench), 5) << "20 s";
}

TEST(HookbehCycleEdges, SilenceCountsFromTheTake) {
  Bench bench(HookbehArgs{.silence_secs = 21});
  bench.alive = false;
  for (int i = 0; i < 20; ++i) {
    bench.cycle();
  }
  EXPECT_EQ(bench.give(Bench::take()).state, HookState::Active);
  EXPECT_EQ(activeFor(bench), 5);
}

TEST(HookbehCycleEdges, TheFirstBeatOfAllCounts) {
  Bench bench(HookbehArgs{.silence_secs = 21});
  bench.alive = false;
  bench.cycle();
  bench.give(Bench::take());
  bench.cycle();
  bench.inputs.heartbeat = 1;
  bench.cycle();
  EXPECT_EQ(activeFor(bench), 5);
}

TEST(HookbehCycleEdges, AHeartbeatOfZeroBeforeTheTakeCountsFromThere) {
  Bench bench(HookbehArgs{.silence_secs = 21});
  bench.beats = 50;
  bench.cycle();
  bench.beats = -1;
  bench.give(Bench::take());
  EXPECT_EQ(bench.inputs.heartbeat, 0);
  bench.cycle();
  bench.alive = false;
  EXPECT_EQ(activeFor(bench), 5) << "1 is newer";
}

TEST(HookbehCycleEdges, AHeartbeatThatIsNotThereIsNotCountedFrom) {
  Bench bench(HookbehArgs{.silence_secs = 21});
  bench.beats = 100;
  bench.cycle();
  bench.alive = false;
  bench.inputs.heartbeat = kNan;
  bench.give(Bench::take());
  bench.inputs.heartbeat = 90;  // an old one
  EXPECT_EQ(activeFor(bench), 5);
}

/// Writes an instruction that cannot be understood.
void garble(Bench& bench, double depth) {
  bench.write(Bench::descend(depth));
  bench.inputs.words.check += 1;
}

TEST(HookbehCycleEdges, TheTimeOfGarbledInstructionsCountsFromTheLastGoodOne) {
  Bench bench = taken(25);
  for (int round = 0; round < 2; ++round) {
    garble(bench, 15 + round);
    for (int i = 1; i <= 6; ++i) {
      ASSERT_EQ(bench.cycle().answer, HookAnswer::BadCheck) << round << " " << i;
      ASSERT_EQ(bench.cycle().state, HookState::Active) << round << " " << i;
      i += 1;
    }
    bench.inputs.words.check -= 1;
    ASSERT_EQ(bench.cycle().answer, HookAnswer::Accepted);
  }
}

TEST(HookbehCycleEdges, OldInstructionsCountAsGarbledOnlyAfterAGarbledOne) {
  Bench bench = taken(25);
  const HookbehInputs take = bench.inputs;
  bench.give(Bench::descend(15));
  const auto old = [&] {
    bench.inputs.words.sequence = take.words.sequence;
    return bench.cycle();
  };
  for (int i = 0; i < 30; ++i) {
    ASSERT_EQ(old().answer, HookAnswer::OldSequence);
  }
  garble(bench, 16);
  for (int i = 1; i <= 6; ++i) {
    ASSERT_EQ(bench.cycle().state, HookState::Active) << i;
  }
  EXPECT_EQ(bench.cycle().state, HookState::Silent) << "28 s";
}

TEST(HookbehCycleEdges, OldInstructionsCountAsGarbledAfterAShortGarbledOne) {
  Bench bench = taken(25);
  const HookbehInputs take = bench.inputs;
  bench.give(Bench::descend(15));
  garble(bench, 16);
  const HookbehInputs garbled = bench.inputs;
  bench.inputs.time_s -= 3.5;
  ASSERT_EQ(bench.cycle().answer, HookAnswer::BadCheck) << "for 0.5 s";
  bench.inputs.words.sequence = take.words.sequence;
  for (int i = 1; i <= 6; ++i) {
    ASSERT_EQ(bench.cycle().answer, HookAnswer::OldSequence) << i;
  }
  bench.inputs.words.sequence = garbled.words.sequence;
  EXPECT_EQ(bench.cycle().state, HookState::Silent);
}

TEST(HookbehCycleEdges, NumbersOfCommandsGoUpTo127AndSessionsFromOne) {
  struct Case {
    uint8_t control, vertical, lateral;
    uint32_t session;
    HookAnswer answer;
  };
  constexpr uint8_t kTake = static_cast<uint8_t>(HookControl::Take);
  constexpr uint8_t kDescend = static_cast<uint8_t>(HookVertical::Descend);
  for (const Case& c : {Case{127, kDescend, 0, 1, HookAnswer::BadCommand},
                        {128, kDescend, 0, 1, HookAnswer::BadCheck},
                        {kTake, 127, 0, 1, HookAnswer::BadCommand},
                        {kTake, 128, 0, 1, HookAnswer::BadCheck},
                        {kTake, kDescend, 127, 1, HookAnswer::BadCommand},
                        {kTake, kDescend, 128, 1, HookAnswer::BadCheck},
                        {kTake, kDescend, 0, 0, HookAnswer::BadCheck},
                        {kTake, kDescend, 0, 1, HookAnswer::Accepted}}) {
    Bench bench;
    bench.cycle();
    Instruction instruction = Bench::take(20, c.session);
    instruction.control = static_cast<HookControl>(c.control);
    instruction.vertical = static_cast<HookVertical>(c.vertical);
    instruction.lateral = static_cast<HookLateral>(c.lateral);
    EXPECT_EQ(bench.give(instruction).answer, c.answer)
        << int{c.control} << " " << int{c.vertical} << " " << int{c.lateral} << " " << c.session;
  }
}

TEST(HookbehCycleEdges, AnyStartExceptZeroWaitsForATimeThatFollows) {
  for (const double start : {0.0, 0.5}) {
    Bench bench(HookbehArgs{.start_secs = start});
    EXPECT_EQ(bench.cycle().state, start > 0 ? HookState::Waiting : HookState::Ready);
    EXPECT_EQ(bench.cycle().state, HookState::Ready);
  }
}

TEST(HookbehCycleEdges, WhatIsNotCommandedIsZero) {
  Bench bench;
  const HookbehOutputs out = bench.cycle();
  EXPECT_FALSE(out.commanding);
  EXPECT_EQ(out.heading_mode, HeadingMode::CentreFin);
  EXPECT_EQ(out.heading_rad, 0);
  EXPECT_EQ(out.latitude_ddmm, 0);
  EXPECT_EQ(out.longitude_ddmm, 0);
  EXPECT_EQ(out.pitch_rad, 0);
  EXPECT_EQ(out.pump_cc, 0);
  EXPECT_STREQ(wordsFor(out.doing), "");
  EXPECT_EQ(out.guard, HookGuard::None);
}

TEST(HookbehCycleEdges, AHeadingIsNotAPlaceAndADriftIsNotAHeading) {
  Bench bench = taken(24);
  Instruction instruction = Bench::descend(20);
  for (const HookLateral lateral : {HookLateral::Drift, HookLateral::Heading}) {
    instruction.lateral = lateral;
    instruction.heading_rad = 0.5;
    instruction.latitude_ddmm = 3910;
    instruction.longitude_ddmm = -7350;
    const HookbehOutputs out = bench.give(instruction);
    EXPECT_EQ(out.heading_rad, lateral == HookLateral::Drift ? 0 : 0.5);
    EXPECT_EQ(out.latitude_ddmm, 0);
    EXPECT_EQ(out.longitude_ddmm, 0);
  }
}

TEST(HookbehCycleEdges, NoSessionIsInControlAfterARelease) {
  Bench bench = taken(24);
  EXPECT_EQ(bench.give(Bench::giveBack()).session, 0U);
}

/// Whether a depth that is stuck to the last bit in a dive is detected while something above
/// hookbeh commands the pump `off_cc` from what hookbeh does.
HookGuard stillWithPumpOffBy(double off_cc) {
  Bench bench = taken(24);
  bench.raw_depth = true;
  HookbehOutputs out = bench.cycle();
  for (int i = 0; i < 8 && out.guard == HookGuard::None; ++i) {
    bench.inputs.commanded_pump_cc = out.pump_cc + off_cc;
    out = bench.cycle();
  }
  return out.guard;
}

TEST(HookbehCycleEdges, ABehaviourAboveItHasThePumpWhereItIsMoreThanThirtyCcOff) {
  for (const double off : {0.0, 30.0, -30.0}) {
    EXPECT_EQ(stillWithPumpOffBy(off), HookGuard::DepthFrozen) << off;
  }
  for (const double off : {30.5, -30.5}) {
    EXPECT_EQ(stillWithPumpOffBy(off), HookGuard::None) << off;
  }
}

TEST(HookbehCycleEdges, ANewSessionMayStayWhereTheOneBeforeWasTooDeep) {
  Bench bench = taken(24);
  bench.inputs.depth_m = 30.1;
  EXPECT_EQ(bench.cycle().guard, HookGuard::TooDeep);
  bench.inputs.depth_m = 29.5;
  bench.alive = false;
  EXPECT_LT(activeFor(bench), 100);
  bench.alive = true;
  EXPECT_EQ(bench.give(Bench::take(30, 2)).guard, HookGuard::None);
}

TEST(HookbehCycleEdges, GoesBackFromWhereTheGuardEndedAndNotFromWhereItHadCome) {
  Bench bench;
  bench.cycle();
  bench.inputs.depth_m = 20;
  bench.give(Bench::take(20));
  for (int i = 0; i < 4; ++i) {
    bench.cycle();
  }
  bench.inputs.altitude_m = 4.9;
  EXPECT_EQ(bench.cycle().guard, HookGuard::NearBottom);
  bench.inputs.depth_m = 17;
  EXPECT_EQ(bench.cycle().guard, HookGuard::NearBottom);
  bench.inputs.depth_m = 18.8;
  bench.inputs.altitude_m = 60;
  EXPECT_STREQ(wordsFor(bench.cycle().doing), "hover") << "within two metres of its depth";
}

TEST(HookbehCycleEdges, ADepthIsNotKeptFromItsFirstMinute) {
  // 59 s of readings: 4 s, 13 times 4 s, and 3 s.
  Bench bench;
  bench.raw_depth = true;
  const auto cycle = [&](double depth, double step_s) {
    bench.inputs.depth_m = depth;
    bench.inputs.time_s += step_s - 4;
    return bench.cycle();
  };
  cycle(10, 4);
  bench.write(Bench::take(20));
  for (int i = 0; i < 13; ++i) {
    cycle(10 + i % 2 * 1e-6, 4);
  }
  EXPECT_EQ(cycle(10, 3).guard, HookGuard::None);
  EXPECT_EQ(cycle(25, 4).guard, HookGuard::DepthJumps);
  EXPECT_EQ(cycle(25, 4).guard, HookGuard::None) << "what it said first held for nothing";
}

TEST(HookbehCycleEdges, ADepthThatIsNotBelievedReachesNoTarget) {
  Bench bench = taken(24);
  bench.inputs.depth_m = 16;
  EXPECT_STREQ(wordsFor(bench.cycle().doing), "dive_to");
  bench.raw_depth = true;
  bench.inputs.depth_m = 20.5;
  EXPECT_EQ(bench.cycle().guard, HookGuard::DepthJumps);
  bench.inputs.depth_m = 18.5;
  EXPECT_STREQ(wordsFor(bench.cycle().doing), "dive_to");
}

/// A vehicle whose depth goes up by `rises_m` in each of three cycles before hookbeh has it.
Bench movedBefore(double greatest_m, double rises_m) {
  HookbehArgs args;
  args.greatest_depth_m = greatest_m;
  Bench bench(args);
  bench.raw_depth = true;
  bench.inputs.depth_m = 20;
  bench.cycle();
  for (int i = 0; i < 3; ++i) {
    bench.inputs.depth_m -= rises_m;
    bench.cycle();
  }
  bench.write(Bench::take(greatest_m));
  return bench;
}

/// Cycles of 4 s until the dive whose depth flickers is given up; at most 200.
int untilGivenUp(Bench& bench) {
  const double depth = bench.inputs.depth_m;
  for (int cycles = 1; cycles <= 200; ++cycles) {
    bench.inputs.depth_m = depth + cycles % 2 * 0.01;
    if (bench.cycle().guard == HookGuard::NoDepthGained) {
      return cycles;
    }
  }
  return 0;
}

TEST(HookbehCycleEdges, AFirstDiveCountsFromTheThirdCycleOn) {
  // 10 m at 0.44 m/s times 0.4 / 0.7854 are 44.6 s: 12 cycles after the 12 s that do not count,
  // the first of which is the one of the Take.
  Bench bench = movedBefore(30, 0);
  EXPECT_EQ(untilGivenUp(bench), 1 + 3 + 12);
}

TEST(HookbehCycleEdges, ADepthThatMovedBeforeTheFirstDiveHasMoved) {
  // 26 m in 116 s; one that had not moved would end after 20 m, in 90 s.
  Bench bench = movedBefore(43, 1);
  EXPECT_EQ(bench.inputs.depth_m, 17);
  EXPECT_GT(untilGivenUp(bench), 1 + 3 + 24);
  Bench still = movedBefore(43, 0.1);
  EXPECT_LT(untilGivenUp(still), 1 + 3 + 24);
}

TEST(HookbehCycleEdges, ACtdIsKnownTenSecondsAfterItsFirstAgreement) {
  for (const double last_s : {2.5, 3.0}) {
    HookbehArgs args;
    Bench bench(args);
    bench.raw_depth = true;
    bench.inputs.depth_m = 26;
    const auto cycle = [&](double step_s) {
      bench.inputs.depth_m += 0.01;
      bench.inputs.ctd_bar = (bench.inputs.depth_m + 4.5) / 10;  // deeper than the limit
      bench.inputs.time_s += step_s - 4;
      return bench.cycle();
    };
    cycle(4);
    bench.write(Bench::take(20));
    EXPECT_EQ(cycle(3).guard, HookGuard::None);
    EXPECT_EQ(cycle(last_s).guard, last_s < 3 ? HookGuard::None : HookGuard::TooDeep) << last_s;
  }
}

TEST(HookbehCycleEdges, ACtdThatMovesIsBelievedTenSecondsAfterItDiffered) {
  Bench bench(HookbehArgs{.greatest_depth_m = 100});
  bench.raw_depth = true;
  bench.inputs.depth_m = 10;
  double ctd = 30;
  const auto cycle = [&](double step_s) {
    bench.inputs.depth_m += 0.001;
    bench.inputs.ctd_bar = ctd / 10;
    ctd += 1.3;
    bench.inputs.time_s += step_s - 4;
    return bench.cycle();
  };
  cycle(4);
  bench.write(Bench::take(20));
  cycle(2);
  EXPECT_EQ(cycle(2).guard, HookGuard::None) << "it has moved now";
  EXPECT_EQ(cycle(1.5).guard, HookGuard::None) << "9.5 s";
  EXPECT_EQ(cycle(0.5).guard, HookGuard::DepthsDisagree) << "10 s";
}

TEST(HookbehCycleEdges, JumpsCountFromZero) {
  Bench bench(HookbehArgs{.greatest_depth_m = 100});
  bench.raw_depth = true;
  const auto cycle = [&](double depth, double step_s) {
    bench.inputs.depth_m = depth;
    bench.inputs.time_s += step_s - 4;
    return bench.cycle();
  };
  cycle(kNan, 4);
  cycle(10, 0.5);
  bench.write(Bench::take(20));
  for (const double depth : {40.0, 80.0, 40.0, 80.0, 40.0}) {  // never where it was before
    EXPECT_EQ(cycle(depth, 1.9).guard, HookGuard::DepthJumps);
  }
  EXPECT_EQ(cycle(bench.inputs.depth_m, 0.25).guard, HookGuard::None) << "9.5 s, and it stays";
}

/// The defaults of the b_args, as the README and the vehicle's mission files have them.
TEST(HookbehArgsEdges, DefaultsAreAsTheReadmeHasThem) {
  const HookbehArgs args;
  EXPECT_EQ(args.start_secs, 0);
  EXPECT_EQ(args.greatest_depth_m, 30);
  EXPECT_EQ(args.least_altitude_m, 5);
  EXPECT_EQ(args.steepest_pitch_rad, 0.61);
  EXPECT_EQ(args.shallowest_pitch_rad, 0.19);
  EXPECT_EQ(args.silence_secs, 24);
  EXPECT_EQ(args.dive_pump_cc, -230);
  EXPECT_EQ(args.climb_pump_cc, 230);
  EXPECT_EQ(args.hold_secs, 12);
}

TEST(HookbehHullEdges, WhatIsNarrowedIsNarrowedExactly) {
  HookbehArgs args;
  args.greatest_depth_m = 200.5;
  args.least_altitude_m = 0;
  args.silence_secs = 600.5;
  args.dive_pump_cc = 0;
  HookbehArgs narrowed = within(args, kHull);
  EXPECT_EQ(narrowed.greatest_depth_m, 200);
  EXPECT_EQ(narrowed.least_altitude_m, 2);
  EXPECT_EQ(narrowed.silence_secs, 600);
  EXPECT_EQ(narrowed.dive_pump_cc, 0);
  args.greatest_depth_m = args.least_altitude_m = args.silence_secs = kNan;
  narrowed = within(args, kHull);
  EXPECT_TRUE(std::isnan(narrowed.greatest_depth_m)) << "a broken limit";
  EXPECT_TRUE(std::isnan(narrowed.least_altitude_m)) << "likewise";
  EXPECT_TRUE(std::isnan(narrowed.silence_secs)) << "silence";
}

TEST(HookbehBoundsEdges, AWholeCircleIsAHeadingToEitherSide) {
  Instruction instruction = Bench::take(20);
  instruction.lateral = HookLateral::Heading;
  const double circle = 6.283185307179586;
  for (const double way : {1.0, -1.0}) {
    instruction.heading_rad = way * circle;
    EXPECT_EQ(hookbehCheckBounds(&instruction, given(HookbehArgs{})), HookAnswer::Accepted) << way;
    instruction.heading_rad = way * (circle + 0.00001);
    EXPECT_EQ(hookbehCheckBounds(&instruction, given(HookbehArgs{})), HookAnswer::BadCommand)
        << way;
  }
}

TEST(HookbehClockEdges, AStepOfLessThanASecondIsOne) {
  HookCycleClock clock = begun(hookCycleClockInit);
  hookCycleClockAdvance(&clock, 1000, kNan, kNan);
  hookCycleClockAdvance(&clock, 1000.5, kNan, kNan);
  EXPECT_EQ(clock.step_s, 0.5);
  EXPECT_TRUE(clock.follows);
  clock = {};
  hookCycleClockAdvance(&clock, 1000, 5000, kNan);
  hookCycleClockAdvance(&clock, 1000.5, 5001.5, kNan);
  EXPECT_EQ(clock.step_s, 0.5) << "they agree";
}

/// A pilot under one instruction, with the depth the test gives.
struct FlownEdge {
  explicit FlownEdge(const Instruction& instruction, HookbehArgs with = {}) : args(with) {
    hookPilotBegin(&pilot, &instruction);
  }
  VerticalCommand at(double depth_m, double step_s = 4) {
    VerticalCommand command;
    hookPilotVertical(&pilot, given(Surroundings{depth_m}), step_s, &args, &command);
    return command;
  }
  VerticalCommand goBackFrom(double depth_m) {
    hookPilotGoBack(&pilot, given(Surroundings{depth_m}), &args, false);
    return at(depth_m);
  }
  HookbehArgs args;
  HookPilot pilot = begun(hookPilotInit);
};

TEST(HookbehPilotEdges, WhereOnlyTheVerticalIsAnotherItIsAnotherInstruction) {
  FlownEdge flown(Bench::descend(20));
  EXPECT_STREQ(wordsFor(flown.at(10).doing), "dive_to");
  hookPilotFollow(&flown.pilot, given(Bench::vertical(HookVertical::Surface, 20)));
  EXPECT_STREQ(wordsFor(flown.at(10).doing), "surface");
}

TEST(HookbehPilotEdges, NoVerticalKeepsAllOfTheOneInForce) {
  FlownEdge flown(Bench::descend(20));
  Instruction none = Bench::vertical(HookVertical::None, 99);
  none.pitch_rad = 1;
  hookPilotFollow(&flown.pilot, &none);
  EXPECT_EQ(flown.pilot.in_force.depth_m, 20);
  EXPECT_EQ(flown.pilot.in_force.pitch_rad, -0.4);
}

TEST(HookbehPilotEdges, WithinTwoMetresNothingIsGoneBackTo) {
  FlownEdge dived(Bench::descend(20));
  EXPECT_STREQ(wordsFor(dived.at(20).doing), "hold");
  EXPECT_STREQ(wordsFor(dived.goBackFrom(20).doing), "hold") << "it holds on";
  dived.at(20, 12);
  EXPECT_STREQ(wordsFor(dived.goBackFrom(18).doing), "hover");
  EXPECT_STREQ(wordsFor(dived.goBackFrom(17.99).doing), "dive_to");
  FlownEdge climbed(Bench::ascend(20));
  EXPECT_STREQ(wordsFor(climbed.at(20).doing), "hold");
  climbed.at(20, 12);
  EXPECT_STREQ(wordsFor(climbed.goBackFrom(22).doing), "hover");
  EXPECT_STREQ(wordsFor(climbed.goBackFrom(22.01).doing), "climb_to");
}

TEST(HookbehPilotEdges, ASurfaceIsNotGoneBackFrom) {
  FlownEdge flown(Bench::vertical(HookVertical::Surface, 20));
  flown.at(20);
  EXPECT_STREQ(wordsFor(flown.goBackFrom(5).doing), "surface");
}

TEST(HookbehPilotEdges, AHoverClimbsAtTheUsualPitch) {
  const VerticalCommand climb = FlownEdge(Bench::vertical(HookVertical::Hover, 20)).at(30);
  EXPECT_STREQ(wordsFor(climb.doing), "climb_to");
  EXPECT_EQ(climb.pitch_rad, 0.4538);
}

TEST(HookbehPilotEdges, AClimbIsHeldHoweverDeepItIs) {
  FlownEdge flown(Bench::ascend(20));
  EXPECT_STREQ(wordsFor(flown.at(20).doing), "hold");
  EXPECT_STREQ(wordsFor(flown.at(21.25).doing), "hold");
}

TEST(HookbehPilotEdges, ItHoldsToTheEndOfItsTime) {
  FlownEdge flown(Bench::descend(20));
  EXPECT_STREQ(wordsFor(flown.at(20).doing), "hold");
  EXPECT_STREQ(wordsFor(flown.at(20, 11.5).doing), "hold") << "0.5 s are left";
  EXPECT_STREQ(wordsFor(flown.at(20, 0.5).doing), "hover");
  EXPECT_STREQ(wordsFor(FlownEdge(Bench::descend(20), {.hold_secs = 0.5}).at(20).doing), "hold");
}

}  // namespace
}  // namespace glider::hooks
