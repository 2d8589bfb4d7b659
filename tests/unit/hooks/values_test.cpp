// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/protocol/instruction.h"
#include "hooks/protocol/numbers.h"
#include "hooks/protocol/steps.h"

#include <gtest/gtest.h>

#include <tuple>

namespace glider::hooks {
namespace {

Instruction example() {
  Instruction instruction;
  instruction.session = 7;
  instruction.sequence = 258;
  instruction.control = HookControl::Take;
  instruction.vertical = HookVertical::Descend;
  instruction.lateral = HookLateral::Waypoint;
  instruction.depth_m = 20.1;
  instruction.pitch_rad = -0.454;
  instruction.heading_rad = 1.3;
  instruction.latitude_ddmm = 3910.5;
  instruction.longitude_ddmm = -7349.8058;
  return instruction;
}

TEST(Values, RealNumbersGoInWholeStepsOnceAndForAll) {
  Instruction exact = example();
  exact.depth_m = 20.10049;
  exact.pitch_rad = -0.4537856;
  exact.longitude_ddmm = -7349.805814;
  const Instruction carried = inSteps(exact);
  EXPECT_EQ(carried.depth_m, 20.1) << "a millimetre";
  EXPECT_EQ(carried.pitch_rad, -0.45379);
  EXPECT_EQ(carried.latitude_ddmm, 3910.5);
  EXPECT_EQ(carried.longitude_ddmm, -7349.80581);
  EXPECT_EQ(inSteps(carried).pitch_rad, carried.pitch_rad);
  EXPECT_EQ(checkValue(carried), checkValue(exact));
  EXPECT_NE(checkValue(carried), checkValue(example()));
}

TEST(Values, WhatAWordCannotCarryIsFarOut) {
  const double nan = __builtin_nan("");
  const double infinity = __builtin_inf();
  Instruction instruction = example();
  for (const auto& [value, depth, latitude] : {std::tuple{nan, -3000.0, -20000.0},
                                               {infinity, 3000.0, 20000.0},
                                               {-infinity, -3000.0, -20000.0},
                                               {1e300, 3000.0, 20000.0}}) {
    instruction.depth_m = instruction.latitude_ddmm = value;
    EXPECT_EQ(inSteps(instruction).depth_m, depth);
    EXPECT_EQ(inSteps(instruction).latitude_ddmm, latitude);
    Instruction got;
    EXPECT_TRUE(instructionOf(wordsOf(instruction), &got)) << "hookbeh refuses it by its limits";
  }
}

TEST(Values, WordsThatAreNotOfAnInstructionAreNone) {
  Instruction got;
  Instruction sampled = example();
  sampled.sampling = 33;
  ASSERT_TRUE(instructionOf(wordsOf(sampled), &got));
  for (const InstructionWord& one : kInstructionWords) {
    InstructionWords words = wordsOf(sampled);
    words.*one.word = __builtin_nan("");
    EXPECT_FALSE(instructionOf(words, &got));
    words = wordsOf(sampled);
    words.*one.word += 1;
    EXPECT_FALSE(instructionOf(words, &got));
  }
  InstructionWords words = wordsOf(example());
  words.session += 0.25;
  EXPECT_FALSE(instructionOf(words, &got)) << "not a whole number";
}

// In the middle between two steps, and a hair from there, after six decimals and a float32: each
// word goes back to the step that was sent.
TEST(Values, EveryStepSurvivesSixDecimalsAndTheArray) {
  const auto cut = [](double x) {
    return static_cast<double>(static_cast<int64_t>(x * 1e6)) / 1e6;
  };
  const auto survives = [&](double step, uint32_t per_unit, uint32_t bytes, double least,
                            double most) {
    const int32_t most_steps = bytes == 4 ? kHookMostStepsOf4 : kHookMostStepsOf8;
    const int64_t first = hookWholeSteps(least, per_unit, kHookMostStepsOf8);
    const int64_t last = hookWholeSteps(most, per_unit, kHookMostStepsOf8);
    for (int64_t i = first; i <= last; i += (last - first) / 100000 + 1) {
      const double sent = static_cast<double>(i) / per_unit;
      const double kept = bytes == 4 ? hookAsFloat32(sent) : sent;
      ASSERT_EQ(hookWholeSteps(cut(kept), per_unit, most_steps), i) << step;
      ASSERT_EQ(
          hookWholeSteps(hookAsFloat32(bytes == 4 ? cut(kept) : 0), per_unit, kHookMostStepsOf8),
          bytes == 4 ? i : 0);
    }
  };
  survives(0.001, kHookMetreSteps, 4, 0, 1200);
  survives(0.00001, kHookRadianSteps, 4, -6.28319, 6.28319);
  survives(0.00001, kHookMinuteSteps, 8, -18000, 18000);
}

TEST(Values, TheReadmesCheckValue) {
  EXPECT_EQ(checkValue(example()), 0xB9A4178BU);
}

TEST(Values, EveryFieldCounts) {
  const uint32_t check = checkValue(example());
  auto changed = [&](auto&& change) {
    Instruction other = example();
    change(other);
    return checkValue(other) != check;
  };
  EXPECT_TRUE(changed([](Instruction& i) { i.session = 8; }));
  EXPECT_TRUE(changed([](Instruction& i) { i.sequence = 259; }));
  EXPECT_TRUE(changed([](Instruction& i) { i.control = HookControl::Steer; }));
  EXPECT_TRUE(changed([](Instruction& i) { i.vertical = HookVertical::Ascend; }));
  EXPECT_TRUE(changed([](Instruction& i) { i.lateral = HookLateral::Drift; }));
  EXPECT_TRUE(changed([](Instruction& i) { i.depth_m = 20.2; }));
  EXPECT_TRUE(changed([](Instruction& i) { i.pitch_rad = 0.454; }));
  EXPECT_TRUE(changed([](Instruction& i) { i.heading_rad = 1.4; }));
  EXPECT_TRUE(changed([](Instruction& i) { i.latitude_ddmm = 3910.6; }));
  EXPECT_TRUE(changed([](Instruction& i) { i.longitude_ddmm = 7349.8058; }));
}

TEST(Sequences, NumbersAreNewerUpToHalfOfTheRoundAhead) {
  EXPECT_FALSE(hookIsNewerSequence(0, 0));
  EXPECT_FALSE(hookIsNewerSequence(0, 65534)) << "no number of an instruction";
  EXPECT_TRUE(hookIsNewerSequence(1, 0));
  EXPECT_TRUE(hookIsNewerSequence(32768, 1)) << "half of the round";
  EXPECT_FALSE(hookIsNewerSequence(32769, 1));
  EXPECT_FALSE(hookIsNewerSequence(9, 9));
}

}  // namespace
}  // namespace glider::hooks
