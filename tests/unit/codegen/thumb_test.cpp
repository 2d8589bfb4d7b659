// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Machine code in Thumb, and calls between it and ARM's other encoding.

#include "codegen/llvm/budget/disassembler.h"
#include "tests/unit/codegen/small_program.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>

namespace glider::codegen {
namespace {

using codegen_tests::function;
using codegen_tests::Small;
using testing::ElementsAre;
using testing::HasSubstr;

/// A function in Thumb; `align`: of its address, in bytes.
std::string thumb(const std::string& name, const std::string& body, unsigned align = 4) {
  return ".thumb\n.balign " + std::to_string(align) + "\n.thumb_func\n" + function(name, body) +
         ".arm\n.balign 4\n";
}

Small inThumb(const std::string& body) {
  return {"ts7800", thumb("_start", body)};
}

/// The instructions of `_start` in Thumb.
std::vector<Instruction> codeOf(const std::string& body) {
  return inThumb(body).image().code();
}

TEST(Thumb, CallsGoThereAndBack) {
  for (const char* before : {"", "nop\n"}) {  // a blx to ARM code counts from a multiple of 4
    const Small small("ts7800",
                      function("_start", "push {r4, lr}\n bl odd\n pop {r4, pc}") +
                          thumb("odd", "push {r4, r5, lr}\n sub sp, #40\n " + std::string(before) +
                                           "bl even\n bl leaf\n add sp, #40\n"
                                           "pop {r4, r5, pc}") +
                          function("even", "sub sp, sp, #16\n add sp, sp, #16\n bx lr") +
                          thumb("leaf", "sub sp, #4\n add sp, #4\n bx lr"));
    EXPECT_EQ(small.bytes(), 8 + 12 + 40 + 16) << before;
  }
}

TEST(Thumb, ItsInstructionsHaveTwoOrFourBytes) {
  const auto code = codeOf("movs r0, #1\n bl 1f\n 1: bne 1b\n b 1b");
  ASSERT_GE(code.size(), 4u);
  EXPECT_EQ(code[0].size, 2u);
  EXPECT_EQ(code[1].size, 4u);
  EXPECT_EQ(code[1].flow, Flow::Call);
  EXPECT_EQ(code[1].target, code[2].address);
  EXPECT_EQ(code[2].flow, Flow::JumpIf);
  EXPECT_EQ(code[2].target, code[2].address);
  EXPECT_EQ(code[3].flow, Flow::Jump);
  EXPECT_EQ(code[3].target, code[2].address);
}

TEST(Thumb, TheStackPointerMovesByNumbers) {
  EXPECT_EQ(inThumb("push {r7, lr}\n add r7, sp, #4\n sub sp, #24\n subs r4, r7, #4\n mov sp, r4\n"
                    "pop {r7, pc}")
                .bytes(),
            8 + 24);
  const std::string room =
      "push {r4, lr}\n ldr r4, 1f\n add sp, r4\n ldr r4, 2f\n add sp, r4\n"
      "pop {r4, pc}\n .balign 4\n 1: .word -1000\n 2: .word 1000";
  EXPECT_EQ(inThumb(room).bytes(), 8 + 1000);
  EXPECT_FALSE(
      inThumb("beq 3f\n" + room.substr(0, room.find("add")) + "3: " + room.substr(room.find("add")))
          .bytes())
      << "it may come from elsewhere";
  const auto unknown = inThumb("push {r4, lr}\n add sp, r4\n pop {r4, pc}").bytes();
  ASSERT_FALSE(unknown);
  EXPECT_THAT(unknown.error(), HasSubstr("it is not known how deep"));
  const auto lost = inThumb("push {r4, lr}\n sub sp, #8\n pop {r4, pc}").bytes();
  ASSERT_FALSE(lost);
  EXPECT_THAT(lost.error(), HasSubstr("not restored"));
}

TEST(Thumb, SaysWhereThingsLie) {
  for (const uint64_t pad : {0U, 1U}) {
    const auto code = codeOf(std::string(pad == 0 ? "" : "nop\n") +
                             "ldr r3, 1f\n add r2, pc\n adr r1, 1f\n ldr r5, [r6, #4]\n bx lr\n"
                             ".balign 4\n 1: .word 77");
    ASSERT_GE(code.size(), pad + 5) << "the word is not code";
    const uint64_t word = (code[pad + 4].address + 2 + 3) & ~uint64_t{3};
    const Instruction &loads = code[pad], &adds = code[pad + 1], &names = code[pad + 2];
    EXPECT_EQ(loads.mentions.count, 1);
    EXPECT_EQ(loads.mentions.numbers[0], word);
    EXPECT_EQ(loads.mentions.literal_to, 3);
    EXPECT_EQ(adds.mentions.pc_plus, 2);
    EXPECT_EQ(adds.mentions.pc_ahead, 4);
    EXPECT_EQ(adds.mentions.count, 0);
    EXPECT_EQ(names.mentions.numbers[0], word);
    EXPECT_EQ(names.mentions.literal_to, Mentions::kNone);
    EXPECT_EQ(code[pad + 3].mentions.count, 0);
  }
}

TEST(Thumb, APointerToItIsOdd) {
  const auto taken = [](const std::string& word) {
    const Small small("ts7800", function("_start", "bx lr") + thumb("odd", "bx lr") +
                                    function("even", "bx lr") + ".data\n.balign 4\n" + word);
    std::vector<std::string> names;
    for (const uint64_t address : small.image().takenFunctions()) {
      names.push_back(small.image().symbolAt(address));
    }
    return names;
  };
  EXPECT_THAT(taken(".word odd, even"), ElementsAre("_start", "odd", "even"));
  EXPECT_THAT(taken(".word odd - 1, even + 1"), ElementsAre("_start"));
}

TEST(Thumb, ADistanceFromItsPlaceIsAPointer) {
  const Small small("ts7800", thumb("_start",
                                    "ldr r0, 2f\n 1: add r0, pc\n bx r0\n .balign 4\n"
                                    "2: .word odd - (1b + 4)") +
                                  thumb("other", "bx lr") + thumb("odd", "bx lr"));
  std::vector<std::string> names;
  for (const uint64_t address : small.image().takenFunctions()) {
    names.push_back(small.image().symbolAt(address));
  }
  EXPECT_THAT(names, ElementsAre("_start", "odd"));
}

TEST(Thumb, ReturnsAndTraps) {
  const auto code = codeOf("bx lr\n pop {r4, pc}\n udf #3\n .inst.n 0xdefe\n bx r3\n blx r3");
  ASSERT_GE(code.size(), 6u);
  EXPECT_EQ(code[0].flow, Flow::Return);
  EXPECT_EQ(code[1].flow, Flow::Return);
  for (const size_t trap : {2U, 3U}) {
    EXPECT_EQ(code[trap].flow, Flow::Return) << trap;
    EXPECT_TRUE(code[trap].stack.stops) << trap;
  }
  EXPECT_EQ(code[4].flow, Flow::JumpByPointer);
  EXPECT_EQ(code[5].flow, Flow::CallByPointer);
}

TEST(Thumb, WhatItsProcessorLacksLeadsToAnUnknownPlace) {
  const auto code = codeOf(".inst.n 0xb100\n mov pc, r3\n add pc, r3\n bx lr");  // Thumb-2's cbz
  ASSERT_GE(code.size(), 4u);
  EXPECT_EQ(code[0].flow, Flow::Unknown);
  EXPECT_EQ(code[0].size, 2u);
  EXPECT_EQ(code[0].stack.writes, 0xFFFF & ~(1U << 13));
  EXPECT_EQ(code[1].flow, Flow::Unknown) << "a switch";
  EXPECT_EQ(code[2].flow, Flow::Unknown);
}

}  // namespace
}  // namespace glider::codegen
