// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// How deep the stack is after one instruction and another, and where two ways meet.

#include "codegen/llvm/budget/stack_state.h"

#include "codegen/llvm/budget/stack_effect.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace glider::codegen {
namespace {

constexpr uint8_t kStackPointer = 13;
using Depth = std::optional<int64_t>;

/// "sub sp, sp, #bytes", perhaps under a condition.
StackEffect moves(int64_t bytes, const char* condition = "") {
  StackEffect effect{
      .to = kStackPointer, .from = kStackPointer, .bytes = bytes, .writes = 1U << kStackPointer};
  std::copy_n(condition, condition[0] == 0 ? 0 : 2, effect.condition);
  return effect;
}
StackEffect copies(uint8_t to, uint8_t from) {
  return {.to = to, .from = from, .writes = static_cast<uint16_t>(1U << to)};
}
StackEffect underA(const char* condition) {
  return moves(0, condition);
}

StackState after(std::initializer_list<StackEffect> effects, int64_t depth = 0) {
  StackState state(kArmStack, depth);
  for (const StackEffect& effect : effects) {
    state.apply(effect);
  }
  return state;
}
Depth deepAfter(std::initializer_list<StackEffect> effects) {
  return after(effects).depth();
}

TEST(StackState, FollowsThePointer) {
  EXPECT_EQ(after({}, 12).depth(), 12);
  EXPECT_EQ(deepAfter({moves(8), moves(-4)}), 4);
  EXPECT_EQ(deepAfter({moves(8), copies(11, kStackPointer), moves(20), copies(kStackPointer, 11)}),
            8);
  EXPECT_EQ(deepAfter({copies(kStackPointer, 11)}), std::nullopt) << "r11 holds anything";
  StackEffect room = moves(0);
  room.known = false;
  EXPECT_EQ(deepAfter({moves(8), room}), std::nullopt);
  StackEffect other;
  other.writes = 1U << 11;
  EXPECT_EQ(deepAfter({copies(11, kStackPointer), other, copies(kStackPointer, 11)}), std::nullopt);
  other.writes = 1U << 10 | 1U << 12 | 1U << kStackPointer;
  EXPECT_EQ(deepAfter({copies(11, kStackPointer), other, copies(kStackPointer, 11)}), 0);
  other.writes = 1U << 14;
  EXPECT_EQ(deepAfter({copies(14, kStackPointer), other, copies(kStackPointer, 14)}), std::nullopt)
      << "the last one";
}

TEST(StackState, ACallTakesWhatItNeedNotKeep) {
  for (uint8_t i = 0; i < kArmStack.count; ++i) {
    if (i != kStackPointer) {
      StackState state = after({copies(i, kStackPointer)}, 8);
      state.call(0);
      EXPECT_EQ(state.depth(), 8);
      state.apply(copies(kStackPointer, i));
      const bool lost = i < 4 || i == 12 || i == 14;
      EXPECT_EQ(state.depth(), lost ? std::nullopt : Depth(8)) << int{i};
    }
  }
  StackState x86(kX86Stack, 20);
  x86.call(4);
  EXPECT_EQ(x86.depth(), 16);
  StackState lost = after({copies(kStackPointer, 11)});
  lost.call(4);
  EXPECT_EQ(lost.depth(), std::nullopt);
  StackState open = after({moves(8, "eq")});
  open.call(0);
  EXPECT_EQ(open.depth(), 8) << "as if it had been carried out";
}

TEST(StackState, AConditionalChangeCountsIfItMakesTheStackDeeper) {
  EXPECT_EQ(deepAfter({moves(8), moves(16, "eq"), moves(0)}), 24);
  EXPECT_EQ(deepAfter({moves(8), moves(-8, "eq"), moves(0)}), 8);
  EXPECT_EQ(deepAfter({moves(8, "eq"), moves(8, "eq"), moves(0)}), 16);
  EXPECT_EQ(deepAfter({moves(8, "eq"), moves(-8, "eq"), moves(0)}), 0) << "both or none";
  EXPECT_EQ(deepAfter({moves(8, "eq"), moves(-8, "ne"), moves(0)}), 8) << "one of them";
  EXPECT_EQ(deepAfter({moves(8, "eq"), moves(-8, "eq"), moves(4, "ne"), moves(0)}), 4);
  StackEffect unknown = copies(kStackPointer, 11);
  unknown.condition[0] = 'e';
  unknown.condition[1] = 'q';
  EXPECT_EQ(deepAfter({moves(8), unknown, moves(0)}), std::nullopt);
}

TEST(StackState, AConditionThatCopiesMayNotHaveCopied) {
  StackEffect maybe = copies(11, kStackPointer);
  maybe.condition[0] = 'e';
  maybe.condition[1] = 'q';
  EXPECT_EQ(deepAfter({maybe, moves(8), copies(kStackPointer, 11)}), std::nullopt);
  EXPECT_EQ(
      deepAfter({copies(11, kStackPointer), moves(8), maybe, moves(8), copies(kStackPointer, 11)}),
      8)
      << "the deeper of the two";
}

TEST(StackState, IsAsTheConditionSays) {
  const StackState open = after({moves(8), moves(-8, "eq")});
  EXPECT_EQ(open.under(underA("eq")).depth(), 0);
  EXPECT_EQ(open.under(underA("ne")).depth(), 8);
  EXPECT_EQ(open.under(underA("")).depth(), 8);
  EXPECT_EQ(open.passing(underA("eq")).depth(), 8);
  const StackState deeper = after({moves(8), moves(16, "eq")});
  EXPECT_EQ(deeper.under(underA("eq")).depth(), 24);
  EXPECT_EQ(deeper.under(underA("ne")).depth(), 24);
  EXPECT_EQ(deeper.passing(underA("eq")).depth(), 8) << "it was not carried out";
  EXPECT_EQ(deeper.passing(underA("ne")).depth(), 24);
  EXPECT_EQ(after({moves(8)}).under(underA("")).depth(), 8);
  EXPECT_EQ(after({moves(8)}).passing(underA("")).depth(), 8);
}

TEST(StackState, TwoWaysMeetAtTheDeeper) {
  StackState flat = after({moves(8)}), deep = after({moves(24)});
  StackState both = flat;
  EXPECT_TRUE(both.join(deep));
  EXPECT_EQ(both.depth(), 24);
  EXPECT_FALSE(both.join(flat)) << "nothing new";
  EXPECT_FALSE(both.join(deep));
  EXPECT_EQ(both.depth(), 24);
  EXPECT_TRUE(both.join(after({copies(kStackPointer, 11)})));
  EXPECT_EQ(both.depth(), std::nullopt);
  StackState copied = after({copies(11, kStackPointer)});
  EXPECT_TRUE(copied.join(after({}))) << "r11 holds anything";
}

TEST(StackState, TwoWaysMeetUnderOneCondition) {
  const StackState little = after({moves(8), moves(4, "eq")}),
                   much = after({moves(8), moves(12, "eq")});
  StackState both = little;
  EXPECT_TRUE(both.join(much));
  EXPECT_EQ(both.under(underA("eq")).depth(), 20);
  EXPECT_EQ(both.passing(underA("eq")).depth(), 8);
  EXPECT_FALSE(both.join(little));
  EXPECT_FALSE(both.join(much));
}

TEST(StackState, TwoWaysMeetUnderDifferentConditions) {
  const StackState open = after({moves(8), moves(-8, "eq")});
  for (const StackState& other : {after({moves(8), moves(-8, "ne")}), after({moves(8)})}) {
    StackState both = open;
    EXPECT_TRUE(both.join(other)) << "the condition is forgotten";
    EXPECT_EQ(both.under(underA("eq")).depth(), 8);
    EXPECT_FALSE(both.join(other));
    StackState turned = other;
    turned.join(open);
    EXPECT_EQ(turned.under(underA("eq")).depth(), 8);
    EXPECT_EQ(turned.under(underA("ne")).depth(), 8);
  }
}

}  // namespace
}  // namespace glider::codegen
