// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/unit/hooks/hookbeh_bench.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstring>

/// What lies in the sensor array from before is not followed: not in the first cycle, nor in any
/// after it.
namespace glider::hooks {
namespace {

using Bench = HookbehBench;

TEST(HookbehStart, AWholeTakeFromBeforeIsNeverFollowed) {
  Bench bench;
  bench.sequence = 500;
  bench.write(Bench::take());
  for (int i = 0; i < 20; ++i) {
    const HookbehOutputs out = bench.cycle();
    ASSERT_EQ(out.state, HookState::Ready) << "cycle " << i;
    ASSERT_EQ(out.answer, HookAnswer::None);
    ASSERT_EQ(out.answered_sequence, 501);
    ASSERT_EQ(out.session, 0U);
    ASSERT_FALSE(out.commanding);
  }
  EXPECT_EQ(bench.give(Bench::take()).state, HookState::Active) << "the next number is followed";
}

TEST(HookbehStart, AGarbledTakeFromBeforeIsNeverFollowed) {
  Bench bench;
  bench.write(Bench::take());
  bench.inputs.words.check += 1;
  HookbehOutputs out = bench.cycle();
  bench.inputs.words.check -= 1;  // and heals
  for (int i = 0; i < 20; ++i) {
    out = bench.cycle();
    ASSERT_EQ(out.state, HookState::Ready) << "cycle " << i;
    ASSERT_EQ(out.answer, HookAnswer::None);
  }
}

TEST(HookbehStart, AnEmptyArrayIsNotTheNumberZero) {
  Bench bench;
  HookbehOutputs out = bench.cycle();
  EXPECT_EQ(out.answered_sequence, 0);
  bench.inputs.words.sequence = 0;  // no number that an SBC gives
  out = bench.cycle();
  EXPECT_EQ(out.answered_sequence, 0);
  EXPECT_EQ(out.answer, HookAnswer::None) << "nothing was instructed";
}

TEST(HookbehStart, AnInvalidSequenceNumberIsNotAnInstruction) {
  Bench bench;
  bench.cycle();
  ASSERT_EQ(bench.give(Bench::take()).answer, HookAnswer::Accepted);
  const uint16_t answered = bench.cycle().answered_sequence;
  for (const double none : {0.0, 65536.0, 1.5, kNan}) {
    bench.inputs.words.sequence = none;
    const HookbehOutputs out = bench.cycle();
    EXPECT_EQ(out.answer, HookAnswer::Accepted) << none;
    EXPECT_EQ(out.answered_sequence, answered) << none;
  }
}

TEST(HookbehStart, GarbledForExactlyTheTimeOfSilenceReleasesControl) {
  // Cycles of 4 s: 24 s are six of them.
  Bench bench(HookbehArgs{.silence_secs = 24});
  bench.cycle();
  ASSERT_EQ(bench.give(Bench::take()).state, HookState::Active);
  bench.write(Bench::descend(15));
  bench.inputs.words.check += 1;
  for (int i = 1; i < 6; ++i) {
    ASSERT_EQ(bench.cycle().state, HookState::Active) << 4 * i << " s";
  }
  EXPECT_EQ(bench.cycle().state, HookState::Silent) << "24 s";
}

TEST(HookbehStart, AGoodInstructionBetweenGarbledOnesCountsFromTheStart) {
  // Seven cycles of 4 s are needed for 25 s.
  Bench bench(HookbehArgs{.silence_secs = 25});
  bench.cycle();
  ASSERT_EQ(bench.give(Bench::take()).state, HookState::Active);
  for (int round = 0; round < 2; ++round) {
    bench.cycle();  // quiet: what lies there is settled
    bench.write(Bench::descend(15 + round));
    bench.inputs.words.check += 1;
    for (int i = 1; i < 7; ++i) {
      ASSERT_EQ(bench.cycle().state, HookState::Active) << round << " " << 4 * i << " s";
    }
    bench.inputs.words.check -= 1;
    ASSERT_EQ(bench.cycle().answer, HookAnswer::Accepted);
  }
}

TEST(HookbehStart, CBeginsWithTheSameArgsAndInputsAsCpp) {
  HookbehArgs args;
  args.hold_secs = args.start_secs = kNan;
  hookbehUsualArgs(&args);
  const HookbehArgs usual;
#define ARG(name, value)                \
  EXPECT_EQ(args.name, value) << #name; \
  EXPECT_EQ(usual.name, value) << #name;
#define PUMP_MODE(name, value)                    \
  EXPECT_EQ(args.name, PumpMode::value) << #name; \
  EXPECT_EQ(usual.name, PumpMode::value) << #name;
#include "hooks/hookbeh/args.def"
  HookbehInputs inputs;
  inputs.time_s = inputs.words.check = inputs.masked = 1;
  inputs.ctd_bar = inputs.wall_time_s = 1;
  hookbehNoInputs(&inputs);
  const HookbehInputs none;
  EXPECT_EQ(std::memcmp(&inputs, &none, offsetof(HookbehInputs, masked) + 1), 0);
}

}  // namespace
}  // namespace glider::hooks
