// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The bound of instructions on small functions written in assembly, which can be counted by hand.

#include "codegen/llvm/budget/worst_path.h"

#include "tests/unit/codegen/small_program.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>
#include <limits>
#include <map>

namespace glider::codegen {
namespace {

using codegen_tests::function;
using codegen_tests::Small;
using testing::HasSubstr;
using Count = std::expected<uint64_t, std::string>;

constexpr uint64_t kMost = std::numeric_limits<uint64_t>::max();

/// What is stated of `_start`, and what pointers reach.
struct Stated {
  Turns turns;
  std::vector<std::string> pointers = {};
  std::string never = {};
};

Count count(const std::string& assembly, const Stated& stated, const char* board = "ts5500") {
  const Small small(board, assembly);
  const Image& image = small.image();
  const Knowledge knowledge{
      [&](const Frame& frame) { return frame.function == "_start" ? stated.turns : Turns{}; },
      [&](const std::vector<Frame>&) {
        std::vector<uint64_t> targets;
        for (const std::string& name : stated.pointers) {
          targets.push_back(*image.function(name));
        }
        return targets;
      },
      [&](const std::string& name) { return name == stated.never; }};
  return WorstPath(image, knowledge).bound(image.entry());
}

Count ofStart(const std::string& body, const Stated& stated = {}) {
  return count(function("_start", body), stated);
}

TEST(WorstPathOf, AWayIsItsInstructions) {
  EXPECT_EQ(ofStart("ret"), 1);
  EXPECT_EQ(ofStart("nop\n nop\n ret"), 3);
  EXPECT_EQ(ofStart("nop\n jmp 1f\n nop\n nop\n 1: ret"), 3);
}

TEST(WorstPathOf, TheHeavierBranchCounts) {
  EXPECT_EQ(ofStart("testl %eax, %eax\n je 1f\n nop\n nop\n 1: ret"), 5);
  EXPECT_EQ(ofStart("testl %eax, %eax\n je 1f\n ret\n 1: nop\n nop\n ret"), 5);
}

TEST(WorstPathOf, CallsWeighWhatTheyCall) {
  const std::string two = function("two", "nop\n ret"),
                    five = function("five", "nop\n nop\n nop\n nop\n ret");
  EXPECT_EQ(count(function("_start", "call two\n call two\n ret") + two, {}), 1 + 2 + 1 + 2 + 1);
  const std::string by_pointer = function("_start", "call *%eax\n ret") + two + five;
  EXPECT_EQ(count(by_pointer, {}), 2) << "what is null is not called";
  EXPECT_EQ(count(by_pointer, {{}, {"two"}}), 4);
  EXPECT_EQ(count(by_pointer, {{}, {"two", "five"}}), 7);
  EXPECT_EQ(count(by_pointer, {{}, {"five", "two"}}), 7);
  EXPECT_EQ(count(by_pointer, {{}, {"five", "two"}, "five"}), 4) << "that one is never called";
  EXPECT_EQ(count(function("_start", "jmp *%eax") + five, {{}, {"five"}}), 6);
  const Count itself = count(by_pointer, {{}, {"_start"}});
  ASSERT_FALSE(itself);
  EXPECT_THAT(itself.error(), HasSubstr("`_start` may call itself"));
}

TEST(WorstPathOf, ALoopTurnsAsStatedAndIsLeftOnce) {
  EXPECT_EQ(ofStart("1: decl %eax\n jne 1b\n ret", {{10, 0}}), 2 * 11 + 1);
  EXPECT_EQ(ofStart("nop\n 1: decl %eax\n jne 1b\n nop\n ret", {{1, 0}}), 1 + 2 * 2 + 2);
  EXPECT_EQ(ofStart("1: decl %eax\n je 2f\n nop\n nop\n jmp 1b\n 2: ret", {{4, 0}}), 5 * 5 + 1);
  EXPECT_EQ(ofStart("1: jmp 1b", {{3, 0}}), 4) << "to itself";
  const Count none = ofStart("1: decl %eax\n jne 1b\n ret");
  ASSERT_FALSE(none);
  EXPECT_THAT(none.error(), HasSubstr("the loop in `_start`"));
}

constexpr const char* kTwoLoops = "1: nop\n 2: decl %eax\n jne 2b\n decl %ebx\n jne 1b\n ret";

TEST(WorstPathOf, LoopsInLoopsTurnAsStated) {
  EXPECT_EQ(ofStart(kTwoLoops, {{10, 3}}), 11 * (1 + 2 * 4 + 2) + 1);
  EXPECT_EQ(ofStart("1: decl %eax\n jne 1b\n 2: decl %ebx\n jne 2b\n ret", {{10, 0}}),
            2 * 2 * 11 + 1)
      << "one after the other";
}

TEST(WorstPathOf, WhatIsNotDistinguishedIsAllMultiplied) {
  EXPECT_EQ(ofStart(kTwoLoops, {{10, 0}}), 11 * (1 + 2 * 11 + 2) + 1)
      << "no inner loop is mentioned";
  EXPECT_EQ(ofStart("1: nop\n 2: nop\n 3: decl %eax\n jne 3b\n decl %ecx\n jne 2b\n"
                    "decl %ebx\n jne 1b\n ret",
                    {{10, 3}}),
            11 * (1 + 4 * (1 + 2 * 44 + 2) + 2) + 1)
      << "nor of one in that";
  EXPECT_EQ(ofStart("testl %eax, %eax\n je 2f\n 1: nop\n 2: decl %eax\n jne 1b\n ret", {{10, 2}}),
            2 + 3 * 11 * 3 + 1)
      << "two ways in";
}

TEST(WorstPathOf, AnInnerLoopThatIsStatedAndNotFoundMultipliesAll) {
  EXPECT_EQ(ofStart("1: decl %eax\n jne 1b\n ret", {{10, 3}}), 2 * 11 * 4 + 1);
}

TEST(WorstPathOf, NothingIsRoundedDown) {
  EXPECT_EQ(ofStart("1: decl %eax\n jmp 1b", {{kMost / 2 - 1, 0}}), kMost - 1);
  EXPECT_EQ(ofStart("1: decl %eax\n jmp 1b", {{kMost / 2, 0}}), kMost);
  EXPECT_EQ(ofStart("1: decl %eax\n jne 1b\n ret", {{kMost, 0}}), kMost);
}

TEST(WorstPathOf, RepeatsAreCounted) {
  EXPECT_EQ(ofStart("movl $7, %ecx\n rep stosl\n ret"), 1 + (1 + 7) + 1);
  EXPECT_EQ(ofStart("movl $0, %ecx\n rep stosl\n ret"), 1 + 1 + 1);
  const Count any = ofStart("rep stosl\n ret");
  ASSERT_FALSE(any);
  EXPECT_THAT(any.error(), HasSubstr("how often `_start` repeats"));
}

TEST(WorstPathOf, WhereItIsUnknownThereIsNoBound) {
  const Count lost = count(function("_start", "ldr pc, [r4]"), {}, "ts7800");
  ASSERT_FALSE(lost);
  EXPECT_THAT(lost.error(), HasSubstr("where `_start` continues"));
  EXPECT_EQ(count(function("_start", "popne {r4, pc}\n nop\n bx lr"), {}, "ts7800"), 3);
  EXPECT_EQ(count(function("_start",
                           "cmp r0, #1\n addls pc, pc, r0, lsl #2\n b 3f\n b 1f\n b 2f\n"
                           "nop\n nop\n nop\n 1: bx lr\n 2: nop\n 3: bx lr"),
                  {}, "ts7800"),
            5);
}

}  // namespace
}  // namespace glider::codegen
