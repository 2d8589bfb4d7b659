// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What budgets read off the machine code of ARM in 64 bits: single instructions, and small
// functions whose depth and ways can be counted by hand.

#include "codegen/llvm/budget/flow_of.h"
#include "codegen/llvm/budget/stack_effect.h"
#include "tests/unit/codegen/small_program.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <gmock/gmock.h>

namespace glider::codegen::aarch64_tests {
namespace {

using codegen_tests::function;
using codegen_tests::Small;
using testing::HasSubstr;

constexpr uint8_t kNone = StackEffect::kNone;
constexpr uint8_t kSp = 31;

TEST(FlowOf, AArch64) {
  const std::pair<Written, Flow> cases[] = {
      {{"add", "x0, x1, x2"}, Flow::Next},
      {{"b", "#16"}, Flow::Jump},
      {{"b.ne", "#16"}, Flow::JumpIf},
      {{"cbz", "x0, #16"}, Flow::JumpIf},
      {{"cbnz", "w0, #16"}, Flow::JumpIf},
      {{"tbz", "w0, #3, #16"}, Flow::JumpIf},
      {{"tbnz", "x0, #33, #16"}, Flow::JumpIf},
      {{"bl", "#16"}, Flow::Call},
      {{"blr", "x3"}, Flow::CallByPointer},
      {{"br", "x3"}, Flow::JumpByPointer},
      {{"ret", ""}, Flow::Return},
      {{"ret", "x3"}, Flow::Unknown},
      {{"brk", "#0x1"}, Flow::Return},
      {{"udf", "#0"}, Flow::Return},
      {{"bic", "x0, x1, x2"}, Flow::Next},
      {{"svc", "#0"}, Flow::Next},
      {{"bti", "c"}, Flow::Next},
  };
  for (const auto& [written, flow] : cases) {
    EXPECT_EQ(aarch64Flow(written), flow) << written.operation << ' ' << written.operands;
  }
}

struct Moves {
  Written written;
  uint8_t to, from;
  int64_t bytes;
};

void expectMoves(const Moves& wanted) {
  SCOPED_TRACE(std::string(wanted.written.operation) + ' ' + std::string(wanted.written.operands));
  const StackEffect effect = aarch64Stack(wanted.written);
  EXPECT_EQ(effect.to, wanted.to);
  if (wanted.to != kNone) {
    EXPECT_EQ(effect.from, wanted.from);
    EXPECT_EQ(effect.bytes, wanted.bytes);
  }
}

TEST(StackEffectOfAArch64, MovesRegisters) {
  const Moves cases[] = {
      {{"sub", "sp, sp, #16"}, kSp, kSp, 16},
      {{"sub", "sp, sp, #2, lsl #12"}, kSp, kSp, 8192},
      {{"add", "sp, sp, #16"}, kSp, kSp, -16},
      {{"sub", "sp, x29, #8"}, kSp, 29, 8},
      {{"add", "x29, sp, #16"}, 29, kSp, -16},
      {{"add", "x30, sp, #16"}, 30, kSp, -16},
      {{"mov", "x29, sp"}, 29, kSp, 0},
      {{"mov", "sp, x29"}, kSp, 29, 0},
      {{"mov", "x0, x1"}, 0, 1, 0},
      {{"and", "sp, x0, #0xfffffffffffffff0"}, kSp, 0, 15},
      {{"and", "sp, x9, #0xffffffffffffffc0"}, kSp, 9, 63},
      {{"stp", "x29, x30, [sp, #-16]!"}, kSp, kSp, 16},
      {{"ldp", "x29, x30, [sp], #32"}, kSp, kSp, -32},
      {{"str", "x30, [sp, #-16]!"}, kSp, kSp, 16},
      {{"ldr", "d8, [sp], #16"}, kSp, kSp, -16},
      {{"st1", "{ v0.16b }, [sp], #16"}, kSp, kSp, -16},
  };
  for (const Moves& wanted : cases) {
    expectMoves(wanted);
  }
}

TEST(StackEffectOfAArch64, SaysNothingOfTheRest) {
  const Written cases[] = {
      {"sub", "sp, sp, x0"},
      {"sub", "sp, sp, x0, lsl #2"},
      {"sub", "sp, sp, #2, lsl #24"},
      {"sub", "sp, sp, w0, uxtw"},
      {"sub", "wsp, wsp, #16"},
      {"add", "x0, x31, #8"},
      {"add", "x0, xzr, #8"},
      {"add", "x0, x1, x2"},
      {"and", "sp, x0, #0xff"},
      {"and", "sp, x0, #0xfffffffffffffff1"},
      {"and", "sp, x0, x1"},
      {"and", "sp, x0, #0xffffffff00000000"},
      {"mov", "x0, #3"},
      {"mov", "w29, wsp"},
      {"mov", "x0, xzr"},
      {"ldr", "x0, [sp, #8]"},
      {"ldr", "x0, [sp]"},
      {"ldr", "x0, [sp, x1]"},
      {"ld1", "{ v0.16b }, [sp], x2"},
      {"ldr", "x0, [x1], #8"},
      {"cmp", "sp, x1"},
      {"subs", "x0, sp, #16"},
      {"nop", ""},
  };
  for (const Written& written : cases) {
    expectMoves({written, kNone, kNone, 0});
  }
}

TEST(StackEffectOfAArch64, OnlyATrapStops) {
  for (const char* stops : {"brk", "udf", "hlt"}) {
    EXPECT_TRUE(aarch64Stack({stops, "#0"}).stops) << stops;
  }
  EXPECT_FALSE(aarch64Stack({"ret", ""}).stops);
}

std::vector<Instruction> codeOf(const std::string& body) {
  return Small("cm4", function("_start", body)).image().code();
}

TEST(DisassemblerOfAArch64, NumbersTheRegisters) {
  for (unsigned i = 0; i < 32; ++i) {
    const std::string name = i == 31 ? "sp" : "x" + std::to_string(i);
    const Instruction one = codeOf("add " + name + ", " + name + ", #16\n ret").front();
    EXPECT_EQ(one.stack.writes, 1U << i) << name;
    EXPECT_EQ(one.mentions.registers, 1U << i) << name;
  }
  EXPECT_EQ(codeOf("add w1, w2, w3").front().mentions.registers, 0b1110U) << "halves";
  EXPECT_EQ(codeOf("add w1, w2, w3").front().stack.writes, 0b0010U);
  EXPECT_EQ(codeOf("ldp x3, x4, [x5], #16").front().stack.writes, 0b111000U);
  EXPECT_EQ(codeOf("bl _start").front().stack.writes & 1U << 30, 1U << 30);
}

TEST(DisassemblerOfAArch64, PairsOfRegistersAreBothWritten) {
  const auto code =
      codeOf(".arch_extension lse\n casp x2, x3, x4, x5, [x6]\n .inst 0x48227cc4\n ret");
  EXPECT_EQ(code[0].flow, Flow::Unknown) << "the board's processor has it not";
  EXPECT_EQ(code[0].size, 4u);
  EXPECT_EQ(code[0].stack.writes, 0x7FFFFFFFU);
}

TEST(DisassemblerOfAArch64, ThePointerIsKnownWhereItIsSaidHowItMoves) {
  EXPECT_TRUE(codeOf("stp x29, x30, [sp, #-16]!").front().stack.known);
  EXPECT_TRUE(codeOf("sub x0, x0, x1").front().stack.known);
  EXPECT_FALSE(codeOf("sub sp, sp, x1").front().stack.known);
  EXPECT_FALSE(codeOf("sub wsp, wsp, #16").front().stack.known);
  EXPECT_FALSE(codeOf("ld1 {v0.16b}, [sp], x2").front().stack.known);
}

TEST(DisassemblerOfAArch64, WhatLeadsElsewhereWithoutARuleIsUnknown) {
  for (const char* other : {"eret", "drps", "ret x3"}) {
    EXPECT_EQ(codeOf(std::string(other) + "\n ret").front().flow, Flow::Unknown) << other;
  }
  EXPECT_EQ(codeOf("svc #0\n ret").front().flow, Flow::Next);
}

TEST(StackBoundOfAArch64, AddsFramesAlongTheDeepestWay) {
  const Small small("cm4", function("_start",
                                    "stp x29, x30, [sp, #-32]!\n bl flat\n bl deep\n"
                                    "ldp x29, x30, [sp], #32\n ret") +
                               function("flat", "sub sp, sp, #16\n add sp, sp, #16\n ret") +
                               function("deep",
                                        "str x30, [sp, #-16]!\n sub sp, sp, #1, lsl #12\n bl flat\n"
                                        "add sp, sp, #1, lsl #12\n ldr x30, [sp], #16\n ret"));
  EXPECT_EQ(small.bytes(), 32 + 16 + 4096 + 16);
}

TEST(StackBoundOfAArch64, AFramePointerTakesTheStackBack) {
  const std::string begin =
                        "stp x29, x30, [sp, #-16]!\n mov x29, sp\n sub x9, sp, #32\n"
                        "and sp, x9, #0xffffffffffffffc0\n bl leaf\n",
                    end = "ldp x29, x30, [sp], #16\n ret";
  const std::string leaf = function("leaf", "mov x9, x29\n ret");
  EXPECT_EQ(Small("cm4", function("_start", begin + "mov sp, x29\n" + end) + leaf).bytes(),
            16 + 32 + 63);
  const auto lost = Small("cm4", function("_start", begin + "mov sp, x9\n" + end) + leaf).bytes();
  ASSERT_FALSE(lost) << "a call does not preserve x9";
  EXPECT_THAT(lost.error(), HasSubstr("it is not known how deep the stack is in `_start`"));
}

TEST(StackBoundOfAArch64, WhatCannotBeFollowedHasNoBound) {
  for (const char* body : {"sub sp, sp, x0\n ret", "sub sp, sp, #16\n ret",
                           "1: str x0, [sp, #-16]!\n cbnz x0, 1b\n ret",
                           "ldr x9, [x0]\n mov sp, x9\n ret", "mov w9, wsp\n mov sp, x9\n ret",
                           "ret x9", "eret", ".inst 0xffffffff\n ret", "bl _start\n ret"}) {
    EXPECT_FALSE(Small("cm4", function("_start", body)).bytes()) << body;
  }
}

TEST(StackBoundOfAArch64, EachBranchIsFollowed) {
  for (const char* branch :
       {"b.hi 1f", "cbz x0, 1f", "cbnz w0, 1f", "tbz x0, #4, 1f", "tbnz w0, #4, 1f"}) {
    const Small small("cm4",
                      function("_start", std::string(branch) + "\n ret\n 1: sub sp, sp, #48\n"
                                                               "add sp, sp, #48\n ret"));
    EXPECT_EQ(small.bytes(), 48) << branch;
  }
}

TEST(StackBoundOfAArch64, ALastCallTakesTheCallersPlace) {
  const std::string deep = function("deep", "sub sp, sp, #64\n add sp, sp, #64\n ret");
  const std::string frame = "str x30, [sp, #-16]!\n ldr x3, [x0, #8]\n",
                    end = "ldr x30, [sp], #16\n";
  EXPECT_EQ(Small("cm4", function("_start", frame + end + "b deep") + deep).bytes(), 64);
  EXPECT_EQ(Small("cm4", function("_start", frame + end + "br x3") + deep).bytes({"deep"}), 64);
  const auto within = Small("cm4", function("_start", frame + "br x3") + deep).bytes({"deep"});
  ASSERT_FALSE(within);
  EXPECT_THAT(within.error(), HasSubstr("not restored"));
  const std::string ends = function("deep", "sub sp, sp, #64\n brk #1");
  EXPECT_EQ(Small("cm4", function("_start", frame + "br x3") + ends).bytes({"deep"}), 16 + 64)
      << "it never returns";
}

/// Whether `br x3` after `before` is taken for a call of another function.
bool calls(const std::string& before, const std::string& data = "") {
  const Small small("cm4", function("first", "ret") + function("_start", before + "\n br x3") +
                               function("deep", "sub sp, sp, #64\n add sp, sp, #64\n ret") + data);
  const auto bytes = small.bytes({"deep"});
  EXPECT_TRUE(!bytes || *bytes == 64);
  return bytes.has_value();
}

TEST(PointerJumps, AreCallsIfTheRegisterHoldsAPointerOnEachWay) {
  EXPECT_TRUE(calls("nop")) << "the function was called with it";
  EXPECT_TRUE(calls("ldr x3, [x0]"));
  EXPECT_TRUE(calls("ldp x2, x3, [x0]"));
  EXPECT_TRUE(calls("ldr x3, [x0, x1, lsl #3]"));
  EXPECT_TRUE(calls("ldr x2, [x0]\n add x3, x0, #8\n mov x3, x2"));
  EXPECT_TRUE(calls("adr x3, deep"));
  EXPECT_TRUE(calls("cbz x0, 1f\n ldr x3, [x0]\n b 2f\n 1: ldr x3, [x1]\n 2: nop"));
  EXPECT_TRUE(calls("1: ldr x3, [x0], #8\n cbz x3, 1b"));
}

TEST(PointerJumps, MayBeSwitchesOtherwise) {
  for (const char* before :
       {"add x3, x3, x1", "add x3, x3, #8", "adr x3, 1f\n 1: nop", "ldrsw x3, [x0]", "ldr w3, [x0]",
        "ldr x2, [x3], #8", "mov x3, #4096", "adrp x3, deep", "sub x3, x0, x1", "eor x3, x3, x0",
        "ldr x3, [x0]\n cbz x0, 1f\n ldr x3, [x1]\n add x3, x3, x2\n 1: nop",
        "ldr x2, [x0]\n add x2, x2, x1\n mov x3, x2", "bl deep",
        "1: cbz x3, 2f\n add x3, x3, x1\n b 1b\n 2: nop"}) {
    EXPECT_FALSE(calls(before)) << before;
  }
  EXPECT_FALSE(
      calls("b 1f\n nop\n 1: .globl inner\n inner: ldr x3, [x0]", ".data\n .xword inner\n"))
      << "a computed goto";
}

TEST(PointerJumps, AreNotCallsWhereASwitchMayLeadToThem) {
  const auto flows = [](const std::string& rows) {
    const Small small("cm4", function("_start",
                                      "add x3, x3, x0\n cmp w8, #1\n b.hi 9f\n adrp x9, table\n"
                                      "add x9, x9, :lo12:table\n adr x10, 7f\n ldrb w11, [x9, x8]\n"
                                      "add x10, x10, x11, lsl #2\n br x10\n"
                                      "7: ret\n 8: br x3\n 9: ldr x3, [x0]\n b 8b") +
                                 ".section .rodata\n table: " + rows);
    std::set<Flow> met;
    for (const Instruction& one : small.image().code()) {
      met.insert(one.flow);
    }
    return met;
  };
  EXPECT_EQ(flows(".byte 0, 1"), (std::set<Flow>{Flow::Next, Flow::JumpIf, Flow::JumpByTable,
                                                 Flow::Jump, Flow::Return, Flow::Unknown}));
}

TEST(PointerJumps, AreNotCallsWhereOtherFunctionsJumpIn) {
  const std::string start = function("_start", "ldr x3, [x0]\n .globl inner\n inner: br x3"),
                    deep = function("deep", "ret");
  EXPECT_TRUE(Small("cm4", start + deep).bytes({"deep"}));
  EXPECT_FALSE(
      Small("cm4", start + deep + function("other", "add x3, x3, x0\n b inner")).bytes({"deep"}));
}

/// Where the switch of `_start` goes, as instructions from its beginning; empty: it is not known.
std::vector<uint64_t> switchOf(const std::string& body, const std::string& table) {
  const Small small("cm4", function("before", "ret") + function("_start", body) +
                               function("behind", "ret") + ".section .rodata\n table: " + table);
  const auto& code = small.image().code();
  const auto at = std::ranges::find(code, Flow::JumpByTable, &Instruction::flow);
  std::vector<uint64_t> targets;
  if (at != code.end()) {
    for (const uint64_t target : small.image().tableTargets(*at)) {
      targets.push_back((target - small.image().entry()) / 4);
    }
  }
  return targets;
}

const std::string kTable = "adrp x9, table\n add x9, x9, :lo12:table\n";
const std::string kCases = "\n br x10\n 7: nop\n 8: nop\n 9: ret";
const std::string kBytes = "adr x10, 7f\n ldrb w11, [x9, x8]\n add x10, x10, x11, lsl #2";

TEST(DisassemblerOfAArch64, ATableHoldsDistances) {
  using Places = std::vector<uint64_t>;
  const std::string compare = "cmp w8, #1\n b.hi 9f\n";
  EXPECT_EQ(switchOf(compare + kTable + kBytes + kCases, ".byte 0, 2, 1"), (Places{8, 10}));
  EXPECT_EQ(
      switchOf(compare + "mov w7, w8\n" + kTable +
                   "adr x10, 7f\n ldrb w11, [x9, w7, uxtw]\n add x10, x10, x11, lsl #2" + kCases,
               ".byte 0, 2, 1"),
      (Places{9, 11}));
  EXPECT_EQ(
      switchOf(compare + kTable +
                   "adr x10, 7f\n ldrh w11, [x9, x8, lsl #1]\n add x10, x10, x11, lsl #2" + kCases,
               ".hword 2, 0, 1"),
      (Places{10, 8}));
  EXPECT_EQ(switchOf(compare + kTable + "ldrsw x11, [x9, x8, lsl #2]\n add x10, x9, x11" + kCases,
                     ".word 7b - table, 9b - table, 8b - table"),
            (Places{7, 9}));
  EXPECT_EQ(switchOf(compare + kTable + kBytes + kCases, ".byte 0, 200"), Places{})
      << "a choice leads out of the function";
  EXPECT_EQ(switchOf(kTable + kBytes + kCases, ".byte 0, 2, 1, 255"), (Places{6, 8, 7}))
      << "without a comparison up to what leads out";
}

TEST(DisassemblerOfAArch64, OnlyWhatIsFollowedIsATable) {
  const std::string compare = "cmp w8, #1\n b.hi 9f\n", rows = ".byte 0, 2, 255";
  const auto targets = [&](const std::string& way) {
    return switchOf(compare + way + kCases, rows).size();
  };
  ASSERT_EQ(targets(kTable + kBytes), 2u);
  EXPECT_EQ(targets("cbz x0, 1f\n" + kTable + "1:" + kBytes), 0u) << "entered in between";
  EXPECT_EQ(targets(kTable + "cbz x0, 1f\n nop\n 1:" + kBytes), 0u);
  EXPECT_EQ(targets(kTable + "mov x9, x0\n" + kBytes), 0u) << "another table";
  EXPECT_EQ(targets(kTable + "bl before\n" + kBytes), 0u) << "the call loses x9";
  EXPECT_EQ(targets(kTable + "adr x10, 7f\n ldrb w11, [x9, x8]\n add x10, x0, x11, lsl #2"), 0u);
  EXPECT_EQ(targets(kTable + "adr x10, 7f\n ldrb w11, [x9, #1]\n add x10, x10, x11, lsl #2"), 0u);
  EXPECT_EQ(targets(kTable + "adr x10, 7f\n ldrsb x11, [x9, x8]\n add x10, x10, x11, lsl #2"), 0u);
  EXPECT_EQ(targets(kTable + "adr x10, 7f\n ldrb w11, [x9, x8]\n sub x10, x10, x11, lsl #2"), 0u);
  EXPECT_EQ(targets(kTable + kBytes + "\n add x10, x10, #4"), 0u);
}

TEST(DisassemblerOfAArch64, ASwitchThatLeadsIntoItselfIsNotFollowed) {
  const std::string end = "\n ldrb w11, [x9, x8]\n add x10, x10, x11, lsl #2\n br x10\n 9: ret",
                    begin = "cmp w8, #1\n b.hi 9f\n" + kTable;
  EXPECT_EQ(switchOf(begin + "adr x10, 9f" + end, ".byte 0, 0").size(), 2u);
  EXPECT_EQ(switchOf(begin + "7: adr x10, 7b" + end, ".byte 0, 4").size(), 0u)
      << "x9 may be another table there";
}

/// Any of these leaves the number of choices open, so the row behind the table counts too.
TEST(DisassemblerOfAArch64, AComparisonBoundsOnlyItsRegister) {
  const std::string rows = ".byte 0, 2, 1, 255";
  for (const char* before :
       {"cmp w8, #1\n b.hs 9f\n", "cmp w8, #1\n b.ls 9f\n", "cmp w7, #1\n b.hi 9f\n",
        "cmp w8, #1\n nop\n b.hi 9f\n", "cmp w8, #1\n b.hi 9f\n add w8, w8, #1\n",
        "cmp w8, w1\n b.hi 9f\n", "cmn w8, #1\n b.hi 9f\n", "tst w8, #1\n b.hi 9f\n"}) {
    EXPECT_EQ(switchOf(before + kTable + kBytes + kCases, rows).size(), 3u) << before;
  }
}

bool isTaken(const std::string& body, const std::string& data = "") {
  const Small small("cm4", function("_start", body) + function("far", "ret") + data);
  const auto& taken = small.image().takenFunctions();
  return std::ranges::find(taken, *small.image().function("far")) != taken.end();
}

TEST(TakenFunctions, OfAArch64AreMadeOfPageAndNumber) {
  EXPECT_FALSE(isTaken("bl far\n b far"));
  EXPECT_TRUE(isTaken("ret", ".data\n .xword far"));
  EXPECT_TRUE(isTaken("adr x3, far\n ret"));
  EXPECT_TRUE(isTaken("adrp x3, far\n nop\n add x4, x3, :lo12:far\n ret"));
  EXPECT_TRUE(isTaken("ldr x3, =far\n ret\n .ltorg"));
  EXPECT_FALSE(isTaken("adrp x3, far\n add x3, x3, #4\n ret")) << "a place of this function";
  EXPECT_TRUE(isTaken("adrp x3, far\n cbz x0, 1f\n add x3, x3, #4\n 1: ret"))
      << "the page may be added to elsewhere";
  EXPECT_TRUE(isTaken("adrp x3, far\n str x3, [x0]\n add x3, x3, #4\n ret")) << "or kept";
  EXPECT_TRUE(isTaken("adrp x3, far\n add x4, x3, #4\n ret")) << "it is still there";
  EXPECT_TRUE(isTaken(
      ".rept 70\n nop\n .endr\n adrp x3, far\n .rept 70\n nop\n .endr\n add x3, x3, #4\n ret"))
      << "too far off to be sure";
}

TEST(TakenFunctions, OfAArch64MayBeNumbers) {
  EXPECT_TRUE(isTaken("movz x3, #:abs_g1:far\n movk x3, #:abs_g0_nc:far\n ret"));
  EXPECT_FALSE(isTaken("movz x3, #:abs_g1:far\n movk x3, #7\n ret"));
}

}  // namespace
}  // namespace glider::codegen::aarch64_tests
