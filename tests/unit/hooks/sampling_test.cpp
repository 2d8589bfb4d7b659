// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// How often instruments read: the codes, their word in an instruction, and what hookbeh passes on.

#include "hooks/protocol/sampling.h"

#include "hooks/protocol/instruction.h"
#include "tests/unit/hooks/hookbeh_bench.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

namespace glider::hooks {
namespace {

constexpr uint32_t kCtdOff = 1, kSecondEveryFourSecs = 6U << 5U;

Instruction sampled(uint32_t sampling) {
  Instruction instruction = HookbehBench::descend(15);
  instruction.sequence = 7;
  instruction.sampling = sampling;
  return instruction;
}

TEST(SamplingWord, ACodeIsTheLongestPeriodThatIsNoLonger) {
  for (const auto& [seconds, carried] : {std::pair(0.0, 0.0),
                                         {0.5, 0},
                                         {1, 1},
                                         {3.99, 3},
                                         {4, 4},
                                         {7, 6},
                                         {59, 50},
                                         {60, 60},
                                         {61, 60},
                                         {3600, 3600},
                                         {1e9, 3600}}) {
    EXPECT_EQ(hookSamplingSecs(hookSamplingCode(seconds)), carried) << seconds;
  }
}

TEST(SamplingWord, EachCodeIsThatOfItsPeriod) {
  double before = -1;
  for (uint32_t code = kHookSamplingFastest; code < kHookSamplingCodes; ++code) {
    EXPECT_EQ(hookSamplingCode(hookSamplingSecs(code)), code);
    EXPECT_GT(hookSamplingSecs(code), before);
    before = hookSamplingSecs(code);
  }
  EXPECT_LT(hookSamplingSecs(kHookSamplingOff), 0);
  EXPECT_TRUE(std::isnan(hookSamplingSecs(kHookSamplingOfVehicle)));
  EXPECT_TRUE(std::isnan(hookSamplingSecs(kHookSamplingCodes)));
}

TEST(SamplingWord, TheWordHasFiveBitsForEachInstrument) {
  EXPECT_EQ(hookSamplingOf(kCtdOff + kSecondEveryFourSecs, 0), kHookSamplingOff);
  EXPECT_EQ(hookSamplingSecs(hookSamplingOf(kCtdOff + kSecondEveryFourSecs, 1)), 4);
  EXPECT_EQ(hookSamplingOf(kHookMostSampling, kHookMostInstruments - 1), kHookSamplingCodes - 1);
}

TEST(SamplingWord, CrossesTheLineInAWordUnderTheCheckValue) {
  for (const uint32_t word : {0U, kCtdOff, static_cast<uint32_t>(kHookMostSampling)}) {
    const InstructionWords words = wordsOf(sampled(word));
    Instruction back;
    ASSERT_TRUE(instructionOf(words, &back)) << word;
    EXPECT_EQ(back.sampling, word);
  }
}

/// A vehicle from before that word, and a program that does not give it.
TEST(SamplingWord, AWordThatWasNeverSetIsThatOfAnInstructionWithoutIt) {
  InstructionWords words = wordsOf(sampled(0));
  words.sampling = kNan;
  Instruction back;
  EXPECT_TRUE(instructionOf(words, &back));
  EXPECT_EQ(back.sampling, 0U);
  words = wordsOf(sampled(kCtdOff));
  words.sampling = kNan;
  EXPECT_FALSE(instructionOf(words, &back)) << "it is still on its way";
}

TEST(SamplingWord, TheWordOfAnotherInstructionDoesNotPass) {
  Instruction back;
  for (const auto& [sent, there] : {std::pair(0U, kCtdOff), {kCtdOff, 0U}, {kCtdOff, 2U}}) {
    InstructionWords words = wordsOf(sampled(sent));
    words.sampling = there;
    EXPECT_FALSE(instructionOf(words, &back)) << sent << " " << there;
  }
}

TEST(SamplingWord, AWordThatIsNoneIsRefused) {
  Instruction back;
  for (const double word : {-1.0, 0.5, 1073741824.0, 1e300, HUGE_VAL}) {
    InstructionWords words = wordsOf(sampled(0));
    words.sampling = word;
    EXPECT_FALSE(instructionOf(words, &back)) << word;
  }
}

HookbehOutputs given(HookbehBench& bench, Instruction instruction, uint32_t sampling) {
  instruction.sampling = sampling;
  bench.inputs.words.sampling = sampling;
  return bench.give(instruction);
}

TEST(HookbehSampling, IsOrderedWhileTheSbcIsInControl) {
  HookbehBench bench;
  EXPECT_EQ(bench.cycle().sampling, 0U);
  EXPECT_EQ(given(bench, HookbehBench::take(), kCtdOff).sampling, kCtdOff);
  EXPECT_EQ(bench.cycle().sampling, kCtdOff);
  EXPECT_EQ(given(bench, HookbehBench::descend(18), kSecondEveryFourSecs).sampling,
            kSecondEveryFourSecs);
  EXPECT_EQ(given(bench, HookbehBench::descend(18), 0).sampling, 0U);
}

TEST(HookbehSampling, EndsWithTheSession) {
  HookbehBench bench;
  bench.cycle();
  given(bench, HookbehBench::take(), kCtdOff);
  bench.alive = false;
  HookbehOutputs out;
  for (int i = 0; i < 30; ++i) {
    out = bench.cycle();
  }
  EXPECT_EQ(out.state, HookState::Silent);
  EXPECT_EQ(out.sampling, 0U);
}

TEST(HookbehSampling, GoesOnWhileAGuardClimbs) {
  HookbehBench bench;
  bench.cycle();
  given(bench, HookbehBench::take(), kCtdOff);
  bench.inputs.depth_m = 31;
  const HookbehOutputs out = bench.cycle();
  EXPECT_NE(out.guard, HookGuard::None);
  EXPECT_EQ(out.sampling, kCtdOff);
}

TEST(HookbehSampling, OfARefusedInstructionIsNotObeyed) {
  HookbehBench bench;
  bench.cycle();
  given(bench, HookbehBench::take(), kCtdOff);
  const HookbehOutputs out = given(bench, HookbehBench::descend(500), kSecondEveryFourSecs);
  EXPECT_EQ(out.answer, HookAnswer::TooDeep);
  EXPECT_EQ(out.sampling, kCtdOff);
}

}  // namespace
}  // namespace glider::hooks
