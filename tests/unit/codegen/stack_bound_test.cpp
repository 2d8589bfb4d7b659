// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The bound of the stack on small functions written in assembly, whose depth can be counted by
// hand.

#include "codegen/llvm/budget/stack_bound.h"

#include "codegen/llvm/budget/callees.h"
#include "codegen/llvm/budget/stack_state.h"
#include "tests/unit/codegen/small_program.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <gmock/gmock.h>

namespace glider::codegen {
namespace {

using codegen_tests::function;
using codegen_tests::Small;
using testing::HasSubstr;

TEST(StackBoundOfArm, AddsFramesAlongTheDeepestWay) {
  const Small small("ts7800",
                    function("_start", "push {r4, lr}\n bl flat\n bl deep\n pop {r4, pc}") +
                        function("flat", "sub sp, sp, #16\n add sp, sp, #16\n bx lr") +
                        function("deep",
                                 "str lr, [sp, #-4]!\n sub sp, sp, #40\n bl flat\n"
                                 "add sp, sp, #40\n ldr pc, [sp], #4"));
  EXPECT_EQ(small.bytes(), 8 + 44 + 16);
}

TEST(StackBoundOfArm, AFramePointerTakesTheStackBack) {
  const Small small("ts7800", function("_start",
                                       "push {r11, lr}\n mov r11, sp\n sub sp, sp, #20\n"
                                       "bic sp, sp, #31\n bl leaf\n"
                                       "mov sp, r11\n pop {r11, pc}") +
                                  function("leaf", "mov r11, r11\n bx lr"));
  EXPECT_EQ(small.bytes(), 8 + 20 + 31);
}

TEST(StackBoundOfArm, WhatACallLosesIsNotAFramePointer) {
  const Small small("ts7800", function("_start",
                                       "push {r4, lr}\n mov r12, sp\n sub sp, sp, #20\n"
                                       "bl leaf\n mov sp, r12\n pop {r4, pc}") +
                                  function("leaf", "bx lr"));
  const auto none = small.bytes();
  ASSERT_FALSE(none);
  EXPECT_THAT(none.error(), HasSubstr("it is not known how deep the stack is in `_start`"));
}

TEST(StackBoundOfArm, ConditionsThatAreTheSameGoTogether) {
  const Small small("ts7800", function("_start",
                                       "push {r4, lr}\n sub sp, sp, #24\n cmp r0, #3\n"
                                       "addhs sp, sp, #24\n pophs {r4, pc}\n push {r5, r6}\n"
                                       "add sp, sp, #32\n pop {r4, pc}"));
  EXPECT_EQ(small.bytes(), 8 + 24 + 8);
  const Small torn("ts7800", function("_start",
                                      "push {r4, lr}\n sub sp, sp, #24\n cmp r0, #3\n"
                                      "addhs sp, sp, #24\n poplo {r4, pc}\n"
                                      "add sp, sp, #24\n pop {r4, pc}"));
  ASSERT_FALSE(torn.bytes());
  EXPECT_THAT(torn.bytes().error(), HasSubstr("not restored"));
}

TEST(StackBoundOfArm, ASwitchGoesToItsChoices) {
  const Small small("ts7800", function("_start",
                                       "push {r4, lr}\n cmp r0, #1\n"
                                       "addls pc, pc, r0, lsl #2\n b 3f\n b 1f\n b 2f\n"
                                       "1: push {r5}\n add sp, sp, #4\n b 3f\n"
                                       "2: sub sp, sp, #64\n add sp, sp, #64\n"
                                       "3: pop {r4, pc}"));
  EXPECT_EQ(small.bytes(), 8 + 64);
}

TEST(StackBoundOfArm, APartMayReturnForItsFunction) {
  const Small small("ts7800", function("_start",
                                       "push {r4, lr}\n bleq 1f\n pop {r4, pc}\n"
                                       "1: push {r5}\n pop {r5}\n bxne lr\n"
                                       "pop {r4, pc}"));
  EXPECT_EQ(small.bytes(), 8 + 4);
}

TEST(StackBoundOfArm, RoomOfAnySizeHasNoBound) {
  const Small small("ts7800", function("_start",
                                       "push {r11, lr}\n mov r11, sp\n sub sp, sp, r0\n"
                                       "mov sp, r11\n pop {r11, pc}"));
  ASSERT_FALSE(small.bytes());
  EXPECT_THAT(small.bytes().error(), HasSubstr("it is not known how deep"));
}

TEST(StackBoundOfArm, ALoopThatPushesHasNoBound) {
  const Small small("ts7800",
                    function("_start", "1: push {r4}\n subs r0, r0, #1\n bne 1b\n bx lr"));
  ASSERT_FALSE(small.bytes());
  EXPECT_THAT(small.bytes().error(), HasSubstr("may grow in a loop of `_start`"));
}

TEST(StackBoundOfX86, CountsReturnAddresses) {
  const Small small("ts5500",
                    function("_start", "pushl %ebx\n call deep\n popl %ebx\n ret") +
                        function("deep", "subl $28, %esp\n call flat\n addl $28, %esp\n ret") +
                        function("flat", "pushl %eax\n popl %eax\n ret"));
  EXPECT_EQ(small.bytes(), 4 + 4 + 28 + 4 + 4);
}

TEST(StackBoundOfX86, AReturnMayTakeArguments) {
  const Small small("ts5500",
                    function("_start", "1: pushl %eax\n call taker\n decl %ebx\n jne 1b\n ret") +
                        function("taker",
                                 "pushl %ebp\n movl %esp, %ebp\n andl $-16, %esp\n"
                                 "subl $32, %esp\n leave\n ret $4"));
  EXPECT_EQ(small.bytes(), 4 + 4 + 4 + 15 + 32);
}

TEST(StackBoundOfX86, ACallOfTheNextPlaceIsAPush) {
  const Small small("ts5500", function("_start", "call 1f\n1: popl %ebx\n ret"));
  EXPECT_EQ(small.bytes(), 4);
}

TEST(StackBoundOfX86, TheKernelsCallTakesAFewWords) {
  const Small small("ts5500", function("_start", "pushl %ebx\n call *%gs:16\n popl %ebx\n ret"));
  EXPECT_EQ(small.bytes(), 4 + kX86Stack.kernel_bytes);
}

TEST(StackBoundOfX86, BehindWhatNeverReturnsThereIsNothing) {
  const Small small("ts5500", function("_start", "subl $12, %esp\n call gone") +
                                  function("odd", "popl %eax\n popl %eax\n ret") +
                                  function("gone", "pushl %eax\n1: jmp 1b"));
  EXPECT_EQ(small.bytes(), 12 + 4 + 4);
}

TEST(StackBoundOfX86, AStackFromMemoryHasNoBound) {
  const Small small("ts5500", function("_start", "movl 4(%eax), %esp\n ret"));
  ASSERT_FALSE(small.bytes());
}

TEST(StackBoundOfX86, PointersReachWhatIsSaid) {
  const Small small("ts5500", function("_start", "call *%eax\n jmp *%edx") +
                                  function("small", "pushl %eax\n popl %eax\n ret") +
                                  function("large", "subl $99, %esp\n addl $99, %esp\n ret"));
  EXPECT_EQ(small.bytes(), 4) << "what is null is not called";
  EXPECT_EQ(small.bytes({"small"}), 4 + 4);
  EXPECT_EQ(small.bytes({"small", "large"}), 4 + 99);
  const auto itself = small.bytes({"_start"});
  ASSERT_FALSE(itself);
  EXPECT_THAT(itself.error(), HasSubstr("`_start` may call itself"));
}

/// As a seat within a program: both send through the same function.
TEST(StackBoundOfArm, WhatIsExcludedIsNotCalledWithin) {
  const std::string outer = function("outer", "push {r4-r7, lr}\n bl send\n pop {r4-r7, pc}");
  const Small small("ts7800", function("_start", "push {r4, lr}\n bl send\n pop {r4, pc}") +
                                  function("send", "push {r4, lr}\n blx r4\n pop {r4, pc}") +
                                  outer + function("inner", "push {r4-r9}\n pop {r4-r9}\n bx lr"));
  const auto itself = small.bytes({"outer", "inner"});
  ASSERT_FALSE(itself);
  EXPECT_THAT(itself.error(), HasSubstr("may call itself"));
  EXPECT_EQ(small.bytes({"outer", "inner"}, 1, {{"outer", {"outer"}}}), 8 + 8 + 20 + 8 + 24);
  EXPECT_EQ(small.bytes({"outer", "inner"}, 1, {{"outer", {"outer", "inner"}}}),
            8 + 8 + 20 + 8 + 0);
  EXPECT_FALSE(small.bytes({"outer", "inner"}, 1, {{"outer", {"inner"}}}));
  EXPECT_FALSE(small.bytes({"outer", "inner"}, 1, {{"inner", {"outer"}}}))
      << "it is not active when outer is called";
}

TEST(StackBoundOfX86, SoManyCallsAtOnceAreCounted) {
  const Small small("ts5500", function("_start",
                                       "subl $20, %esp\n call _start\n"
                                       "subl $8, %esp\n addl $28, %esp\n ret"));
  ASSERT_FALSE(small.bytes());
  EXPECT_EQ(small.bytes({}, 2), 24 + 28);
  EXPECT_EQ(small.bytes({}, 3), 24 + 24 + 28);
}

bool has(const Image& image, const char* name) {
  const auto& taken = image.takenFunctions();
  return std::ranges::find(taken, *image.function(name)) != taken.end();
}

TEST(TakenFunctions, AreThoseWhoseAddressIsSomewhere) {
  const Small arm("ts7800", function("_start", "bl called\n bx lr") + function("called", "bx lr") +
                                function("kept", "bx lr") + ".data\n.word kept\n");
  EXPECT_TRUE(has(arm.image(), "kept"));
  EXPECT_FALSE(has(arm.image(), "called"));
  const Small x86("ts5500", function("_start", "movl $named, %eax\n call called\n ret") +
                                function("called", "ret") + function("named", "ret") +
                                function("kept", "ret") + ".data\n.long kept\n");
  EXPECT_TRUE(has(x86.image(), "named"));
  EXPECT_TRUE(has(x86.image(), "kept"));
  EXPECT_FALSE(has(x86.image(), "called"));
}

TEST(TakenFunctions, OfArmMayBeDistances) {
  const Small small("ts7800", function("_start",
                                       "ldr r3, 2f\n1: add r3, pc, r3\n bx r3\n"
                                       "2: .word far - (1b + 8)") +
                                  function("near", "bx lr") + function("far", "bx lr"));
  EXPECT_TRUE(has(small.image(), "far"));
  EXPECT_FALSE(has(small.image(), "near"));
}

/// Two distances from one register in one function. The first from the place of the second would be
/// the function after `far`.
bool isTakenByChance(const std::string& first_add, const std::string& after_load = "") {
  const Small small("ts7800",
                    function("_start", "ldr r3, 2f\n" + after_load + "\n1: " + first_add +
                                           "\n ldr r3, 4f\n3: add r3, pc, r3\n bx r3\n"
                                           "2: .word far - (1b + 8)\n4: .word other - (3b + 8)") +
                        function("far", "nop\n bx lr") + function("behind", "bx lr") +
                        function("other", "bx lr"));
  EXPECT_TRUE(has(small.image(), "far"));
  EXPECT_TRUE(has(small.image(), "other"));
  return has(small.image(), "behind");
}

TEST(TakenFunctions, OfArmAreNotDistancesFromAnotherPlace) {
  EXPECT_FALSE(isTakenByChance("add r3, pc, r3")) << "the sum replaces the distance";
  EXPECT_TRUE(isTakenByChance("add r4, pc, r3")) << "the distance is still there";
  EXPECT_TRUE(isTakenByChance("addne r3, pc, r3")) << "maybe";
  EXPECT_TRUE(isTakenByChance("add r3, pc, r3", "bne 3f")) << "it may be added there";
}

/// Whether `far`, whose address is a word that `_start` loads, counts as taken: it does unless the
/// word is a distance and nothing else.
bool isTaken(const std::string& between, const std::string& behind = "bx lr") {
  const Small small("ts7800", function("_start", "ldr r3, 2f\n" + between + "\n add r3, pc, r3\n" +
                                                     behind + "\n 2: .word far") +
                                  function("far", "bx lr"));
  return has(small.image(), "far");
}

TEST(TakenFunctions, AreNotWhatIsADistanceOnly) {
  EXPECT_FALSE(isTaken(""));
  EXPECT_FALSE(isTaken("mov r4, r5"));
  EXPECT_FALSE(isTaken("bne 1f\n 1:")) << "it may go on";
  EXPECT_TRUE(isTaken("b 1f\n 1:"));
  EXPECT_TRUE(isTaken("str r3, [r0]")) << "it is read";
  EXPECT_TRUE(isTaken("mov r3, r5")) << "it is another";
  EXPECT_TRUE(isTaken("bl far")) << "r3 may be another";
  EXPECT_TRUE(isTaken("add r5, pc, r5\n mov r4, r3"));
  EXPECT_FALSE(isTaken(".rept 63\n nop\n .endr"));
  EXPECT_TRUE(isTaken(".rept 64\n nop\n .endr")) << "too far off to be sure";
}

/// Whether `far` in Thumb, at 0x20100, counts as taken because of what follows `_start`'s return.
bool isTakenInThumb(const std::string& behind) {
  const Small small("ts7800", ".text\n.balign 256\n.thumb\n.thumb_func\n" +
                                  function("far", "bx lr") + ".balign 4\n.thumb_func\n" +
                                  function("_start", "bx lr\n nop\n" + behind));
  EXPECT_EQ(small.image().function("far"), 0x20100);
  return has(small.image(), "far");
}

TEST(TakenFunctions, AreNotWhatInstructionsInThumbLookLike) {
  EXPECT_FALSE(isTakenInThumb("lsls r1, r0, #4\n movs r2, r0")) << "0101 0002";
  EXPECT_TRUE(isTakenInThumb(".word 0x20101"));
}

TEST(TakenFunctions, MayBeDistancesFromTheTableOfOffsets) {
  const Small small("ts5500", function("_start",
                                       "call 9f\n 9: popl %ebx\n"
                                       "addl $_GLOBAL_OFFSET_TABLE_+(.-9b), %ebx\n"
                                       "leal far@GOTOFF(%ebx), %eax\n ret") +
                                  function("near", "ret") + function("far", "ret"));
  EXPECT_TRUE(has(small.image(), "far"));
  EXPECT_FALSE(has(small.image(), "near"));
}

TEST(TakenFunctions, AreNotThoseThatAreJumpedTo) {
  const Small small("ts5500", function("_start", "testl %eax, %eax\n je called\n jmp jumped") +
                                  function("called", "ret") + function("jumped", "ret"));
  EXPECT_FALSE(has(small.image(), "called"));
  EXPECT_FALSE(has(small.image(), "jumped"));
}

}  // namespace
}  // namespace glider::codegen
