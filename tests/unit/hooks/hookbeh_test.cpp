// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/hookbeh/hookbeh.h"

#include "hooks/hookbeh/hull.h"
#include "hooks/protocol/messages.h"
#include "tests/unit/hooks/hookbeh_bench.h"

#include <gtest/gtest.h>

#include <string>

namespace glider::hooks {
namespace {

using Bench = HookbehBench;

TEST(Hookbeh, WaitsForItsTimeThenIsReadyAndCommandsNothing) {
  HookbehArgs args;
  args.start_secs = 260;
  Bench bench(args);
  HookbehOutputs out;
  for (int i = 0; i < 64; ++i) {
    out = bench.cycle();
    EXPECT_EQ(out.state, HookState::Waiting);
    EXPECT_FALSE(out.commanding);
  }
  out = bench.cycle();
  EXPECT_EQ(bench.inputs.time_s, 260);
  EXPECT_EQ(out.state, HookState::Ready);
  EXPECT_FALSE(out.commanding);
}

TEST(Hookbeh, WaitingRefusesAnInstruction) {
  HookbehArgs args;
  args.start_secs = 260;
  Bench bench(args);
  bench.cycle();
  const HookbehOutputs out = bench.give(Bench::take());
  EXPECT_EQ(out.answer, HookAnswer::NotReady);
  EXPECT_EQ(out.answered_sequence, 1);
  EXPECT_EQ(out.state, HookState::Waiting);
}

TEST(Hookbeh, TakeActivatesAndCommandsInTheSameCycle) {
  Bench bench;
  bench.cycle();
  const HookbehOutputs out = bench.give(Bench::take(20));
  EXPECT_EQ(out.state, HookState::Active);
  EXPECT_EQ(out.answer, HookAnswer::Accepted);
  EXPECT_EQ(out.answered_sequence, 1);
  EXPECT_EQ(out.session, 1U);
  ASSERT_TRUE(out.commanding);
  EXPECT_EQ(out.pump_cc, -230);
  EXPECT_EQ(out.pitch_rad, -0.4);
  EXPECT_STREQ(wordsFor(out.doing), "dive_to");
}

TEST(Hookbeh, WhatLiesInTheArrayAtTheStartIsNotFollowed) {
  Bench bench;
  bench.write(Bench::take());
  HookbehOutputs out = bench.cycle();
  EXPECT_EQ(out.state, HookState::Ready);
  EXPECT_EQ(out.answer, HookAnswer::None);
  EXPECT_EQ(out.answered_sequence, 1) << "told, so that the SBC does not begin with it";
  out = bench.give(Bench::take());
  EXPECT_EQ(out.state, HookState::Active);
}

TEST(Hookbeh, CommandsEveryCycleThroughTheWholeOfADive) {
  Bench bench;
  bench.cycle();
  HookbehOutputs out = bench.give(Bench::take(12));
  std::string seen;
  for (int i = 0; i < 20; ++i) {
    bench.inputs.depth_m += 0.5;
    out = bench.cycle();
    ASSERT_TRUE(out.commanding);
    ASSERT_EQ(out.state, HookState::Active);
    if (!seen.ends_with(wordsFor(out.doing))) {
      seen += std::string(" ") + wordsFor(out.doing);
    }
  }
  EXPECT_EQ(seen, " dive_to hold hover");
  EXPECT_EQ(out.pitch_rad, 0);
  EXPECT_EQ(out.pump_cc, 230) << "far below its depth it lifts with all it has";
}

TEST(Hookbeh, HoldKeepsTheCommandsForItsTime) {
  Bench bench;
  bench.cycle();
  bench.inputs.depth_m = 20.9;
  HookbehOutputs out = bench.give(Bench::take(20));
  for (int i = 0; i < 3; ++i) {
    EXPECT_STREQ(wordsFor(out.doing), "hold")
        << "a target that is passed already is reached at once";
    EXPECT_EQ(out.pump_cc, -230);
    EXPECT_LT(out.pitch_rad, 0);
    out = bench.cycle();
  }
  EXPECT_STREQ(wordsFor(out.doing), "hover");
}

TEST(Hookbeh, ClimbEndsInHoverAndAtTheTopInFloating) {
  for (const double target : {5.0, 0.0}) {
    Bench bench;
    bench.cycle();
    bench.give(Bench::take(20));
    HookbehOutputs out = bench.give(Bench::ascend(target));
    EXPECT_STREQ(wordsFor(out.doing), "climb_to");
    EXPECT_EQ(out.pump_cc, 230);
    EXPECT_GT(out.pitch_rad, 0);
    bench.inputs.depth_m = target;
    for (int i = 0; i < 10; ++i) {
      out = bench.cycle();
    }
    EXPECT_EQ(out.doing, target > 1 ? Doing::Hover : Doing::Surface);
  }
}

TEST(Hookbeh, ADescendOrHoverToLessThanAMetreEndsInFloating) {
  for (const HookVertical vertical : {HookVertical::Descend, HookVertical::Hover}) {
    Bench bench;
    bench.cycle();
    bench.give(Bench::take(20));
    bench.inputs.depth_m = 0.9;
    HookbehOutputs out = bench.give(Bench::vertical(vertical, 0.9));
    for (int i = 0; i < 4; ++i) {
      out = bench.cycle();
    }
    EXPECT_STREQ(wordsFor(out.doing), "surface");
  }
}

TEST(Hookbeh, HoverGoesThereThenLevels) {
  Bench bench;
  bench.cycle();
  bench.give(Bench::take(20));
  HookbehOutputs out = bench.give(Bench::vertical(HookVertical::Hover, 15));
  EXPECT_STREQ(wordsFor(out.doing), "dive_to");
  bench.inputs.depth_m = 14;
  out = bench.cycle();
  EXPECT_STREQ(wordsFor(out.doing), "hover");
  EXPECT_EQ(out.pitch_rad, 0);
  EXPECT_LT(out.pump_cc, 0) << "above its depth it sinks";
  bench.inputs.depth_m = 15;
  for (int i = 0; i < 20; ++i) {
    out = bench.cycle();
  }
  EXPECT_NEAR(out.pump_cc, 0, 25) << "there it rests";
  for (int i = 0; i < 3; ++i) {
    bench.inputs.depth_m += 0.4;
    out = bench.cycle();
  }
  EXPECT_GT(out.pump_cc, 25) << "sinking through it is braked";
  bench.inputs.depth_m = 25;
  out = bench.give(Bench::vertical(HookVertical::Hover, 16));
  EXPECT_STREQ(wordsFor(out.doing), "climb_to");
}

TEST(Hookbeh, SurfaceKeepsClimbing) {
  Bench bench;
  bench.cycle();
  bench.give(Bench::take(20));
  HookbehOutputs out = bench.give(Bench::vertical(HookVertical::Surface));
  for (int i = 0; i < 5; ++i) {
    EXPECT_STREQ(wordsFor(out.doing), "surface");
    EXPECT_EQ(out.pump_cc, 230);
    EXPECT_GT(out.pitch_rad, 0);
    bench.inputs.depth_m = 0;
    out = bench.cycle();
  }
}

TEST(Hookbeh, WithoutAVerticalItFloatsThenKeepsTheOneInForce) {
  Bench bench;
  bench.cycle();
  Instruction nothing = Bench::vertical(HookVertical::None);
  nothing.control = HookControl::Take;
  EXPECT_STREQ(wordsFor(bench.give(nothing).doing), "surface");
  EXPECT_STREQ(wordsFor(bench.give(Bench::descend(20)).doing), "dive_to");
  nothing.control = HookControl::Steer;
  nothing.lateral = HookLateral::Heading;
  nothing.heading_rad = 1;
  const HookbehOutputs out = bench.give(nothing);
  EXPECT_STREQ(wordsFor(out.doing), "dive_to");
  EXPECT_EQ(out.heading_mode, HeadingMode::Heading);
}

TEST(Hookbeh, HoldsNoDiveFarBeyondItsTarget) {
  Bench bench;
  bench.cycle();
  bench.inputs.depth_m = 20.9;
  EXPECT_STREQ(wordsFor(bench.give(Bench::take(20)).doing), "hold");
  bench.inputs.depth_m = 21.1;
  EXPECT_STREQ(wordsFor(bench.cycle().doing), "hover") << "a steep dive would go on for metres";
  bench.inputs.depth_m = 25;
  const HookbehOutputs out = bench.give(Bench::descend(10));
  EXPECT_STREQ(wordsFor(out.doing), "hover")
      << "nor does it dive for a target that was passed long ago";
  EXPECT_EQ(out.pump_cc, 230);
}

TEST(Hookbeh, AnInstructionEqualToTheOneInForceChangesNothing) {
  Bench bench;
  bench.cycle();
  bench.inputs.depth_m = 21;
  bench.give(Bench::take(20));
  bench.cycle();
  bench.cycle();
  EXPECT_STREQ(wordsFor(bench.give(Bench::descend(20)).doing), "hover")
      << "holding did not start again";
}

TEST(Hookbeh, LateralCommands) {
  Bench bench;
  bench.cycle();
  Instruction instruction = Bench::take(20);
  EXPECT_EQ(bench.give(instruction).heading_mode, HeadingMode::CentreFin);
  instruction.lateral = HookLateral::Heading;
  instruction.heading_rad = -1.5;
  HookbehOutputs out = bench.give(instruction);
  EXPECT_EQ(out.heading_mode, HeadingMode::Heading);
  EXPECT_NEAR(out.heading_rad, 6.283185307 - 1.5, 1e-6);
  instruction.lateral = HookLateral::Waypoint;
  instruction.latitude_ddmm = 3910.5;
  instruction.longitude_ddmm = -7349.8058;
  out = bench.give(instruction);
  EXPECT_EQ(out.heading_mode, HeadingMode::Waypoint);
  EXPECT_EQ(out.latitude_ddmm, 3910.5);
  EXPECT_EQ(out.longitude_ddmm, -7349.8058);
  bench.inputs.latitude_ddmm = kNan;
  EXPECT_EQ(bench.cycle().heading_mode, HeadingMode::CentreFin) << "who is lost goes straight on";
  instruction.lateral = HookLateral::Fin;
  for (const double angle : {-0.25, 0.25}) {  // exact as float32
    instruction.heading_rad = angle;
    out = bench.give(instruction);
    EXPECT_EQ(out.answer, HookAnswer::Accepted);
    EXPECT_EQ(out.heading_mode, HeadingMode::Fin);
    EXPECT_EQ(out.fin_rad, angle);
    EXPECT_EQ(out.heading_rad, 0);
    EXPECT_EQ(bench.cycle().fin_rad, angle) << "held, also by a vehicle that is lost";
  }
  instruction.heading_rad = 0.5;
  out = bench.give(instruction);
  EXPECT_EQ(out.answer, HookAnswer::BadFin);
  EXPECT_EQ(out.fin_rad, 0.25) << "the one before stays in force";
  instruction.lateral = HookLateral::Drift;
  out = bench.give(instruction);
  EXPECT_EQ(out.heading_mode, HeadingMode::CentreFin);
  EXPECT_EQ(out.fin_rad, 0);
}

TEST(Hookbeh, TakesEffectOnlyWhenTheSequenceChanges) {
  Bench bench;
  bench.cycle();
  bench.give(Bench::take(20));
  bench.write(Bench::ascend(5));
  bench.inputs.words.sequence = 1;  // its number has not arrived
  const HookbehOutputs out = bench.cycle();
  EXPECT_STREQ(wordsFor(out.doing), "dive_to");
  EXPECT_EQ(out.answer, HookAnswer::Accepted);
  EXPECT_EQ(out.answered_sequence, 1);
}

TEST(Hookbeh, BadCheckIsAnsweredAndHealsWhenTheRestArrives) {
  Bench bench;
  bench.cycle();
  bench.give(Bench::take(20));
  bench.write(Bench::ascend(5));
  const double arrived = bench.inputs.words.hook_depth_m;
  bench.inputs.words.hook_depth_m = 20;  // this part was lost
  HookbehOutputs out = bench.cycle();
  EXPECT_EQ(out.answer, HookAnswer::BadCheck);
  EXPECT_EQ(out.answered_sequence, 2);
  EXPECT_STREQ(wordsFor(out.doing), "dive_to");
  bench.inputs.words.hook_depth_m = arrived;  // written again with the same number
  out = bench.cycle();
  EXPECT_EQ(out.answer, HookAnswer::Accepted);
  EXPECT_EQ(out.answered_sequence, 2);
  EXPECT_STREQ(wordsFor(out.doing), "climb_to");
}

TEST(Hookbeh, SequenceCountsRound) {
  Bench bench;
  bench.cycle();
  bench.sequence = 65533;
  bench.give(Bench::take(20));
  EXPECT_EQ(bench.give(Bench::ascend(5)).answered_sequence, 65535);
  bench.sequence = 0;
  const HookbehOutputs out = bench.give(Bench::descend(20));
  EXPECT_EQ(out.answered_sequence, 1);
  EXPECT_EQ(out.answer, HookAnswer::Accepted);
  EXPECT_STREQ(wordsFor(out.doing), "dive_to");
}

TEST(Hookbeh, SilenceEndsControlWithinItsTimeAndACycle) {
  Bench bench;
  bench.cycle();
  bench.give(Bench::take(20));
  bench.alive = false;
  HookbehOutputs out;
  for (int i = 0; i < 5; ++i) {
    out = bench.cycle();
    EXPECT_EQ(out.state, HookState::Active);
  }
  out = bench.cycle();
  EXPECT_EQ(out.state, HookState::Silent) << "24 s without a beat";
  EXPECT_FALSE(out.commanding);
  EXPECT_EQ(out.session, 0U);
}

TEST(Hookbeh, SilenceIsForGoodUntilANewerSessionTakes) {
  Bench bench;
  bench.cycle();
  bench.give(Bench::take(20, 5));
  bench.alive = false;
  for (int i = 0; i < 10; ++i) {
    bench.cycle();
  }
  bench.alive = true;
  EXPECT_EQ(bench.cycle().state, HookState::Silent) << "a heartbeat alone brings nothing back";
  EXPECT_EQ(bench.give(Bench::descend(20, HookControl::Steer, 5)).answer, HookAnswer::WrongSession);
  EXPECT_EQ(bench.give(Bench::take(20, 5)).answer, HookAnswer::WrongSession);
  EXPECT_EQ(bench.give(Bench::take(20, 4)).answer, HookAnswer::WrongSession);
  EXPECT_EQ(bench.give(Bench::descend(20, HookControl::Steer, 6)).answer, HookAnswer::WrongSession);
  EXPECT_EQ(bench.give(Bench::giveBack(5)).answer, HookAnswer::WrongSession);
  const HookbehOutputs out = bench.give(Bench::take(20, 6));
  EXPECT_EQ(out.answer, HookAnswer::Accepted);
  EXPECT_EQ(out.state, HookState::Active);
  EXPECT_EQ(out.session, 6U);
}

TEST(Hookbeh, ReleaseIsFinal) {
  Bench bench;
  bench.cycle();
  bench.give(Bench::take(20));
  HookbehOutputs out = bench.give(Bench::giveBack());
  EXPECT_EQ(out.state, HookState::Complete);
  EXPECT_EQ(out.answer, HookAnswer::Accepted);
  EXPECT_FALSE(out.commanding);
  out = bench.give(Bench::take(20, 2));
  EXPECT_EQ(out.answer, HookAnswer::NotReady);
  EXPECT_EQ(out.state, HookState::Complete);
}

TEST(Hookbeh, OnlyTheSessionInControlSteers) {
  Bench bench;
  bench.cycle();
  EXPECT_EQ(bench.give(Bench::descend(20)).answer, HookAnswer::WrongSession)
      << "no SBC has taken control yet";
  EXPECT_EQ(bench.give(Bench::giveBack()).answer, HookAnswer::WrongSession);
  bench.give(Bench::take(20, 3));
  Instruction other = Bench::ascend(5);
  other.session = 4;
  HookbehOutputs out = bench.give(other);
  EXPECT_EQ(out.answer, HookAnswer::WrongSession);
  EXPECT_STREQ(wordsFor(out.doing), "dive_to");
  EXPECT_EQ(bench.give(Bench::giveBack(4)).answer, HookAnswer::WrongSession);
  EXPECT_EQ(bench.give(Bench::take(20, 4)).answer, HookAnswer::WrongSession)
      << "one pilot at a time";
  other.session = 3;
  other.control = HookControl::Take;  // its first answer was lost: as good as a Steer
  out = bench.give(other);
  EXPECT_EQ(out.answer, HookAnswer::Accepted);
  EXPECT_STREQ(wordsFor(out.doing), "climb_to");
}

TEST(Hookbeh, ARefusedTakeLeavesItReady) {
  Bench bench;
  bench.cycle();
  const HookbehOutputs out = bench.give(Bench::take(31));
  EXPECT_EQ(out.answer, HookAnswer::TooDeep);
  EXPECT_EQ(out.state, HookState::Ready);
  EXPECT_FALSE(out.commanding);
  EXPECT_EQ(bench.give(Bench::take(30)).state, HookState::Active);
}

TEST(Hookbeh, ARefusedSteerLeavesTheOldOneInForce) {
  Bench bench;
  bench.cycle();
  bench.give(Bench::take(20));
  const HookbehOutputs out = bench.give(Bench::descend(40));
  EXPECT_EQ(out.answer, HookAnswer::TooDeep);
  EXPECT_EQ(out.state, HookState::Active);
  EXPECT_STREQ(wordsFor(out.doing), "dive_to");
  bench.inputs.depth_m = 20;
  EXPECT_STREQ(wordsFor(bench.cycle().doing), "hold");
}

TEST(Hookbeh, TimeThatStopsOrGoesBackwardsStillCounts) {
  for (const double step : {0.0, -100.0, kNan}) {
    Bench bench;
    bench.cycle();
    bench.give(Bench::take(20));
    bench.alive = false;
    int cycles = 0;
    HookbehOutputs out;
    do {
      bench.inputs.time_s += step - 4;
      out = bench.cycle();
    } while (out.state == HookState::Active && ++cycles < 100);
    EXPECT_EQ(cycles, 5) << "six cycles of 4 s for step " << step;
  }
}

TEST(Hookbeh, AGapInItsCyclesThatBothClocksShowCountsForTwentySeconds) {
  Bench bench;
  bench.inputs.wall_time_s = 1e9;
  bench.cycle();
  bench.give(Bench::take(20));
  bench.alive = false;
  bench.inputs.wall_time_s += 64;
  bench.inputs.time_s += 60;
  EXPECT_EQ(bench.cycle().state, HookState::Active);
  EXPECT_EQ(bench.cycle().state, HookState::Silent) << "24 s";
}

TEST(Hookbeh, AGapThatOneClockAloneShowsIsAFalseReading) {
  Bench bench;
  bench.cycle();
  bench.give(Bench::take(20));
  bench.alive = false;
  bench.inputs.time_s += 60000;
  for (int i = 0; i < 5; ++i) {
    EXPECT_EQ(bench.cycle().state, HookState::Active) << i;
  }
  EXPECT_EQ(bench.cycle().state, HookState::Silent);
}

TEST(Hookbeh, OneFalseReadingOfTheTimeDoesNotMakeItReady) {
  HookbehArgs args;
  args.start_secs = 100;
  Bench bench(args);
  bench.cycle();
  bench.inputs.time_s += 1000;
  EXPECT_EQ(bench.cycle().state, HookState::Waiting);
  bench.inputs.time_s -= 1000;
  EXPECT_EQ(bench.cycle().state, HookState::Waiting);
  bench.inputs.time_s = 100;
  bench.cycle();
  EXPECT_EQ(bench.cycle().state, HookState::Ready);
}

TEST(Hookbeh, UnknownTimeIsNeverStart) {
  Bench bench;
  bench.inputs.time_s = kNan;
  EXPECT_EQ(bench.cycle().state, HookState::Waiting);
}

TEST(Hookbeh, NothingButNansDoesNothing) {
  Bench bench;
  bench.cycle();
  bench.give(Bench::take(20));
  bench.inputs = HookbehInputs{{kNan, kNan, kNan, kNan, kNan, kNan, kNan, kNan, kNan, kNan, kNan},
                               kNan,
                               kNan,
                               kNan,
                               kNan,
                               kNan,
                               kNan,
                               kNan};
  bench.alive = false;
  HookbehOutputs out = bench.cycle();
  EXPECT_EQ(out.state, HookState::Active);
  EXPECT_STREQ(wordsFor(out.doing), "climb: depth unknown");
  for (int i = 0; i < 5; ++i) {
    out = bench.cycle();
  }
  EXPECT_EQ(out.state, HookState::Silent);
}

TEST(Hookbeh, ANumberThatIsNoneAmongTheArgsForPumpAndPitchIsTheDefault) {
  for (const double none : {kNan, std::numeric_limits<double>::infinity()}) {
    HookbehArgs args;
    args.dive_pump_cc = args.climb_pump_cc = none;
    args.steepest_pitch_rad = args.shallowest_pitch_rad = none;
    Bench bench(args);
    bench.cycle();
    HookbehOutputs out = bench.give(Bench::take(20));
    EXPECT_EQ(out.answer, HookAnswer::Accepted);
    EXPECT_EQ(out.pump_cc, -230);
    Instruction steep = Bench::descend(25);
    steep.pitch_rad = -0.7;
    EXPECT_EQ(bench.give(steep).answer, HookAnswer::BadPitch);
    steep.pitch_rad = -0.1;
    EXPECT_EQ(bench.give(steep).answer, HookAnswer::BadPitch);
    out = bench.give(Bench::ascend(5));
    EXPECT_EQ(out.pump_cc, 230);
    bench.inputs.depth_m = 31;
    out = bench.cycle();
    EXPECT_NE(out.guard, HookGuard::None);
    EXPECT_EQ(out.pump_cc, kHull.pump_cc);
    EXPECT_NEAR(out.pitch_rad, 0.4538, 1e-9);
    bench.inputs.depth_m = 25;
    out = bench.give(Bench::vertical(HookVertical::Hover, 25));
    EXPECT_STREQ(wordsFor(out.doing), "hover");
    EXPECT_EQ(out.pump_cc, 0);
  }
}

TEST(Hookbeh, HalfWrittenNumbersAreNotAnInstruction) {
  Bench bench;
  bench.cycle();
  bench.give(Bench::take(29));
  const double wrong[] = {kNan, -1, 0.5, 1e30, static_cast<double>(kHookMostSession) + 1};
  double InstructionWords::* const fields[] = {
      &InstructionWords::session, &InstructionWords::control, &InstructionWords::vertical,
      &InstructionWords::lateral, &InstructionWords::check};
  for (const double value : wrong) {
    for (const auto field : fields) {
      bench.inputs.depth_m += 0.2;
      bench.write(Bench::ascend(5));
      bench.inputs.words.*field = value;
      const HookbehOutputs out = bench.cycle();
      EXPECT_EQ(out.answer, HookAnswer::BadCheck);
      EXPECT_STREQ(wordsFor(out.doing), "dive_to");
    }
    bench.write(Bench::ascend(5));
    bench.inputs.words.sequence = value;
    EXPECT_STREQ(wordsFor(bench.cycle().doing), "dive_to");
  }
}

TEST(Hookbeh, AnInstructionThatStaysGarbledIsSilenceThoughTheHeartBeats) {
  HookbehBench bench;
  bench.cycle();
  bench.give(HookbehBench::take());
  bench.write(HookbehBench::ascend(5));
  bench.inputs.words.hook_pitch_rad = 0.5;  // torn
  double garbled_s = 0;
  while (bench.cycle().state == HookState::Active) {
    garbled_s += 4;
    ASSERT_LE(garbled_s, 24);
  }
  EXPECT_GE(garbled_s, 16);
  bench.write(HookbehBench::ascend(5));
  EXPECT_EQ(bench.cycle().answer, HookAnswer::WrongSession) << "too late";
}

TEST(Hookbeh, AGarbledInstructionThatHealsInTimeIsObeyed) {
  HookbehBench bench;
  bench.cycle();
  bench.give(HookbehBench::take());
  for (int round = 0; round < 10; ++round) {
    bench.write(HookbehBench::ascend(5 + round));
    const double right = bench.inputs.words.check;
    bench.inputs.words.check = right + 1;
    for (int i = 0; i < 5; ++i) {
      ASSERT_EQ(bench.cycle().answer, HookAnswer::BadCheck);
    }
    bench.inputs.words.check = right;
    ASSERT_EQ(bench.cycle().answer, HookAnswer::Accepted);
  }
}

}  // namespace
}  // namespace glider::hooks
