// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Who is in control and for how long, what counts as an instruction, and what hookbeh takes for its
// own doing: at the very edges.

#include "tests/unit/hooks/hookbeh_bench.h"

#include <gtest/gtest.h>

namespace glider::hooks {
namespace {

using Bench = HookbehBench;

Bench inControl(const HookbehArgs& args = {}) {
  Bench bench(args);
  bench.cycle();
  EXPECT_EQ(bench.give(Bench::take(20)).state, HookState::Active);
  return bench;
}

/// With 20.5 s of silence allowed: five cycles, and no second more.
HookbehArgs patient() {
  HookbehArgs args;
  args.silence_secs = 20.5;
  return args;
}

void expectFiveCyclesMore(Bench& bench) {
  for (int i = 0; i < 5; ++i) {
    ASSERT_EQ(bench.cycle().state, HookState::Active) << i;
  }
  EXPECT_EQ(bench.cycle().state, HookState::Silent);
}

TEST(HookbehSession, SilenceCountsFromTheNewestBeat) {
  Bench bench = inControl(patient());
  bench.cycle();
  bench.alive = false;
  expectFiveCyclesMore(bench);
}

TEST(HookbehSession, SilenceCountsFromTheTake) {
  Bench bench(patient());
  bench.alive = false;
  for (int i = 0; i < 10; ++i) {
    bench.cycle();
  }
  bench.give(Bench::take(20));
  expectFiveCyclesMore(bench);
}

/// Beats 10, then `between`, then a take, then from 3 to 9 and no more.
HookState afterBeatsBelowTen(double between) {
  Bench bench;
  bench.alive = false;
  bench.inputs.heartbeat = 10;
  bench.cycle();
  bench.inputs.heartbeat = between;
  bench.cycle();
  bench.give(Bench::take(20));
  HookbehOutputs out;
  for (int beat = 3; beat <= 9; ++beat) {
    bench.inputs.heartbeat = beat;
    out = bench.cycle();
  }
  return out.state;
}

TEST(HookbehSession, AHookprogThatBeginsWithNoneIsCountedFromThere) {
  EXPECT_EQ(afterBeatsBelowTen(0), HookState::Active);
}

TEST(HookbehSession, AHeartbeatThatIsNoneChangesNothing) {
  EXPECT_EQ(afterBeatsBelowTen(kNan), HookState::Silent) << "earlier ones that come again";
}

TEST(HookbehSession, AfterAReleaseNoSessionIsInControl) {
  Bench bench = inControl();
  const HookbehOutputs out = bench.give(Bench::giveBack());
  EXPECT_EQ(out.state, HookState::Complete);
  EXPECT_EQ(out.session, 0U);
}

TEST(HookbehSession, IsReadyFromItsTimeOnceTheTimeIsSure) {
  HookbehArgs args;
  args.start_secs = 0.5;
  Bench bench(args);
  EXPECT_EQ(bench.cycle().state, HookState::Waiting);
  EXPECT_EQ(bench.cycle().state, HookState::Ready);
  EXPECT_EQ(Bench().cycle().state, HookState::Ready) << "without a time to wait for";
}

TEST(HookbehSession, GarbledInstructionsCountTogetherUntilAGoodOne) {
  Bench bench = inControl(patient());
  const auto garble = [&](int cycles) {
    bench.write(Bench::descend(20));
    const double good = bench.inputs.words.check;
    ++bench.inputs.words.check;
    for (int i = 0; i < cycles; ++i) {
      ASSERT_EQ(bench.cycle().answer, HookAnswer::BadCheck);
      ASSERT_EQ(bench.cycle().state, HookState::Active) << i;
      ++i;
    }
    bench.inputs.words.check = good;
  };
  garble(4);
  EXPECT_EQ(bench.cycle().answer, HookAnswer::Accepted);
  garble(4);
  EXPECT_EQ(bench.cycle().answer, HookAnswer::Accepted);
  bench.write(Bench::descend(20));
  ++bench.inputs.words.check;
  expectFiveCyclesMore(bench);
}

TEST(HookbehSession, AGoodOneThatLiesThereEndsTheGarbledToo) {
  Bench bench = inControl(patient());
  const HookbehInputs good = bench.inputs;
  for (int round = 0; round < 2; ++round) {
    bench.write(Bench::descend(20));
    ++bench.inputs.words.check;
    for (int i = 0; i < 5; ++i) {
      ASSERT_EQ(bench.cycle().answer, HookAnswer::BadCheck);
    }
    bench.inputs.words.sequence = good.words.sequence;
    ASSERT_EQ(bench.cycle().state, HookState::Active) << round;
  }
}

TEST(HookbehSession, OldInstructionsAreNotGarbled) {
  Bench bench = inControl(patient());
  bench.sequence = 99;
  bench.give(Bench::descend(20));
  bench.inputs.words.sequence = 50;
  for (int i = 0; i < 40; ++i) {
    ASSERT_EQ(bench.cycle().answer, HookAnswer::OldSequence);
  }
  bench.write(Bench::descend(20));
  ++bench.inputs.words.check;
  expectFiveCyclesMore(bench);
}

/// The answer to a steer whose numbers are these, with the check that belongs to them.
HookAnswer answerTo(int control, int vertical, int lateral, uint32_t session = 1) {
  Bench bench = inControl();
  Instruction instruction = Bench::vertical(HookVertical::Surface);
  bench.write(instruction);
  instruction.sequence = bench.sequence;
  instruction.session = session;
  instruction.control = static_cast<HookControl>(control);
  instruction.vertical = static_cast<HookVertical>(vertical);
  instruction.lateral = static_cast<HookLateral>(lateral);
  const Instruction rounded = inSteps(instruction);
  instruction.pitch_rad = rounded.pitch_rad;
  bench.inputs.words.session = session;
  bench.inputs.words.control = control;
  bench.inputs.words.vertical = vertical;
  bench.inputs.words.lateral = lateral;
  bench.inputs.words.check = checkValue(instruction);
  return bench.cycle().answer;
}

TEST(HookbehSession, AnInstructionsNumbersGoUpTo127) {
  const int steer = static_cast<int>(HookControl::Steer);
  const int surface = static_cast<int>(HookVertical::Surface);
  const int drift = static_cast<int>(HookLateral::Drift);
  EXPECT_EQ(answerTo(steer, surface, drift), HookAnswer::Accepted);
  EXPECT_EQ(answerTo(127, surface, drift), HookAnswer::BadCommand);
  EXPECT_EQ(answerTo(steer, 127, drift), HookAnswer::BadCommand);
  EXPECT_EQ(answerTo(steer, surface, 127), HookAnswer::BadCommand);
  EXPECT_EQ(answerTo(128, surface, drift), HookAnswer::BadCheck) << "no number of the array's";
  EXPECT_EQ(answerTo(steer, 128, drift), HookAnswer::BadCheck);
  EXPECT_EQ(answerTo(steer, surface, 128), HookAnswer::BadCheck);
  EXPECT_EQ(answerTo(steer, surface, drift, 2), HookAnswer::WrongSession);
  EXPECT_EQ(answerTo(steer, surface, drift, 0), HookAnswer::BadCheck) << "of no session";
}

TEST(HookbehSession, AHeadingMayBeAWholeTurnEitherWay) {
  for (const double turn : {6.283185307179586, -6.283185307179586}) {
    Bench bench = inControl();
    Instruction instruction = Bench::descend(20);
    instruction.lateral = HookLateral::Heading;
    instruction.heading_rad = turn;
    EXPECT_EQ(bench.give(instruction).answer, HookAnswer::Accepted) << turn;
  }
}

/// Whether a dive that gains no depth is found while all behaviours together command this.
bool isFound(double commanded_pump_cc) {
  Bench bench = inControl();
  bench.inputs.commanded_pump_cc = commanded_pump_cc;
  for (int i = 0; i < 100; ++i) {
    if (bench.cycle().guard == HookGuard::NoDepthGained) {
      return true;
    }
  }
  return false;
}

TEST(HookbehSession, APumpThirtyAsideIsItsOwn) {
  EXPECT_TRUE(isFound(-230));
  EXPECT_TRUE(isFound(-200));
  EXPECT_TRUE(isFound(-260));
  EXPECT_FALSE(isFound(-199.75)) << "another behaviour's";
  EXPECT_FALSE(isFound(-260.25));
}

TEST(HookbehSession, ADepthThatIsNotBelievedHasReachedNothing) {
  Bench bench;
  for (int i = 0; i < 20; ++i) {
    bench.cycle();
  }
  bench.give(Bench::take(20));
  bench.raw_depth = true;
  bench.inputs.depth_m = 21;
  EXPECT_EQ(bench.cycle().guard, HookGuard::DepthJumps);
  bench.inputs.depth_m = 10.5;
  EXPECT_STREQ(wordsFor(bench.cycle().doing), "dive_to");
}

TEST(HookbehSession, ANewSbcIsNotHeldUpByALimitThatTheOneBeforeBroke) {
  Bench bench = inControl();
  bench.inputs.depth_m = 30.1;
  EXPECT_EQ(bench.cycle().guard, HookGuard::TooDeep);
  bench.inputs.depth_m = 29.5;
  EXPECT_EQ(bench.cycle().guard, HookGuard::TooDeep);
  bench.alive = false;
  for (int i = 0; i < 7; ++i) {
    bench.cycle();
  }
  bench.alive = true;
  EXPECT_STREQ(wordsFor(bench.give(Bench::take(29.75, 2)).doing), "dive_to");
}

TEST(HookbehSession, WhereTheGuardEndsCountsNotWhereItClimbed) {
  Bench bench = inControl();
  bench.inputs.depth_m = 20;
  for (int i = 0; i < 5; ++i) {
    bench.cycle();
  }
  bench.inputs.altitude_m = 4.9;
  EXPECT_EQ(bench.cycle().guard, HookGuard::NearBottom);
  bench.inputs.depth_m = 17.5;
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(bench.cycle().guard, HookGuard::NearBottom);
  }
  bench.inputs.depth_m = 18.5;
  bench.inputs.altitude_m = 60;
  EXPECT_STREQ(wordsFor(bench.cycle().doing), "hover") << "it is near enough";
}

}  // namespace
}  // namespace glider::hooks
