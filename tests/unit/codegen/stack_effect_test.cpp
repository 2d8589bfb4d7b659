// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What single instructions do to the stack, as the assembler writes them.

#include "codegen/llvm/budget/stack_effect.h"

#include "codegen/llvm/budget/flow_of.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace glider::codegen {
namespace {

constexpr uint8_t kNone = StackEffect::kNone;
constexpr uint8_t kSp = 13, kLr = 14, kEsp = 4, kEbp = 5;

struct Moves {
  Written written;
  uint8_t to, from;
  int64_t bytes;
};

void expectMoves(const StackEffect& effect, const Moves& wanted) {
  SCOPED_TRACE(std::string(wanted.written.operation) + ' ' + std::string(wanted.written.operands));
  EXPECT_EQ(effect.to, wanted.to);
  if (wanted.to != kNone) {
    EXPECT_EQ(effect.from, wanted.from);
    EXPECT_EQ(effect.bytes, wanted.bytes);
  }
}

TEST(StackEffectOfArm, MovesRegisters) {
  const Moves cases[] = {
      {{"push", "{r4}"}, kSp, kSp, 4},
      {{"push", "{r4, r5, lr}"}, kSp, kSp, 12},
      {{"stmdb", "sp!, {r4, r5}"}, kSp, kSp, 8},
      {{"pop", "{r4}"}, kSp, kSp, -4},
      {{"ldm", "sp!, {r4, r5, pc}"}, kSp, kSp, -12},
      {{"sub", "sp, sp, #16"}, kSp, kSp, 16},
      {{"add", "sp, sp, #16"}, kSp, kSp, -16},
      {{"sub", "sp, r11, #8"}, kSp, 11, 8},
      {{"subs", "sp, sp, #16"}, kSp, kSp, 16},
      {{"sub", "sp, #16"}, kSp, kSp, 16},
      {{"add", "sp, #16"}, kSp, kSp, -16},
      {{"subs", "r4, r7, #4"}, 4, 7, 4},
      {{"adds", "r4, #4"}, 4, 4, -4},
      {{"add", "r11, sp, #4"}, 11, kSp, -4},
      {{"add", "r12, sp, #4"}, 12, kSp, -4},
      {{"add", "lr, sp, #4"}, kLr, kSp, -4},
      {{"sub", "sp, lr, #4"}, kSp, kLr, 4},
      {{"bic", "sp, sp, #31"}, kSp, kSp, 31},
      {{"bic", "sp, r0, #1"}, kSp, 0, 1},
      {{"bic", "sp, r0, #0"}, kSp, 0, 0},
      {{"mov", "r11, sp"}, 11, kSp, 0},
      {{"mov", "sp, r11"}, kSp, 11, 0},
      {{"mov", "sp, lr"}, kSp, kLr, 0},
      {{"str", "lr, [sp, #-8]!"}, kSp, kSp, 8},
      {{"ldr", "pc, [sp], #8"}, kSp, kSp, -8},
      {{"strd", "r4, r5, [sp, #-8]!"}, kSp, kSp, 8},
      {{"ldrd", "r4, r5, [sp], #8"}, kSp, kSp, -8},
  };
  for (const Moves& wanted : cases) {
    expectMoves(armStack(wanted.written), wanted);
  }
}

TEST(StackEffectOfArm, SaysNothingOfTheRest) {
  const Written cases[] = {
      {"stmdb", "r0!, {r4, r5}"},
      {"ldm", "r0!, {r4, r5}"},
      {"push", "{r4-r6}"},
      {"pop", "{r4, sp}"},
      {"pop", "{r4, r5"},
      {"sub", "sp, sp, r0"},
      {"sub", "sp, sp, r0, lsl #2"},
      {"add", "r0, pc, #8"},
      {"add", "pc, r0, #8"},
      {"add", "r0, r13, #8"},
      {"add", "r0, x1, #8"},
      {"add", "r0, rx, #8"},
      {"sub", "sp, sp, 16"},
      {"sub", "sp, sp, #x"},
      {"bic", "sp, sp, #30"},
      {"bic", "sp, sp, #-1"},
      {"mov", "r0, #3"},
      {"mov", "pc, lr"},
      {"mov", "r0, pc"},
      {"mov", "r0, r1, lsl #2"},
      {"ldr", "r0, [sp, #8]"},
      {"ldr", "r0, [sp]"},
      {"ldr", "r0, [sp], r1"},
      {"str", "r0, [sp, r1]!"},
      {"ldr", "sp, [sp], #4"},
      {"ldr", "r0, [r1], #4"},
      {"cmp", "r0, r1"},
      {"mvn", "r0, r1"},
      {"sub", "sp"},
      {"add", "sp, sp, sp, #16"},
  };
  for (const Written& written : cases) {
    expectMoves(armStack(written), {written, kNone, kNone, 0});
  }
}

TEST(StackEffectOfArm, ConditionsAreReadOff) {
  const std::pair<Written, std::string> cases[] = {
      {{"addhs", "sp, sp, #24"}, "hs"},
      {{"subne", "sp, sp, #24"}, "ne"},
      {{"biceq", "sp, sp, #7"}, "eq"},
      {{"movlo", "sp, r11"}, "lo"},
      {{"pushgt", "{r4}"}, "gt"},
      {{"popls", "{r4}"}, "ls"},
      {{"stmdbmi", "sp!, {r4}"}, "mi"},
      {{"ldmpl", "sp!, {r4}"}, "pl"},
      {{"strvs", "r0, [sp, #-4]!"}, "vs"},
      {{"ldrvc", "r0, [sp], #4"}, "vc"},
      {{"strdge", "r4, r5, [sp, #-8]!"}, "ge"},
      {{"ldrdle", "r4, r5, [sp], #8"}, "le"},
      {{"bllt", "#16"}, "lt"},
      {{"blxhi", "r3"}, "hi"},
      {{"bxcc", "lr"}, "cc"},
      {{"bxcs", "lr"}, "cs"},
      {{"add", "sp, sp, #24"}, ""},
      {{"bls", "#16"}, ""},
      {{"adds", "r0, r0, r1"}, ""},
  };
  for (const auto& [written, condition] : cases) {
    const StackEffect effect = armStack(written);
    EXPECT_EQ(std::string(effect.condition, condition.size()), condition) << written.operation;
    EXPECT_EQ(effect.conditional(), !condition.empty()) << written.operation;
    const bool stack = written.operands.find("sp") != std::string_view::npos || condition == "gt";
    EXPECT_EQ(effect.to != kNone, stack || condition == "ls") << written.operation;
  }
  const StackEffect one = armStack({"addhs", ""}), same = armStack({"subhs", ""});
  EXPECT_TRUE(one.sameCondition(same));
  for (const char* other : {"addhi", "addcs", "addls", "add"}) {
    EXPECT_FALSE(one.sameCondition(armStack({other, ""}))) << other;
  }
}

TEST(StackEffectOfArm, OnlyATrapStops) {
  EXPECT_TRUE(armStack({"udf", "#0"}).stops);
  EXPECT_FALSE(armStack({"bx", "lr"}).stops);
}

TEST(StackEffectOfX86, MovesRegisters) {
  const Moves cases[] = {
      {{"pushl", "%ebx"}, kEsp, kEsp, 4},        {{"pushfl", ""}, kEsp, kEsp, 4},
      {{"popl", "%ebx"}, kEsp, kEsp, -4},        {{"popfl", ""}, kEsp, kEsp, -4},
      {{"pushal", ""}, kEsp, kEsp, 32},          {{"popal", ""}, kEsp, kEsp, -32},
      {{"leave", ""}, kEsp, kEbp, -4},           {{"subl", "$12, %esp"}, kEsp, kEsp, 12},
      {{"addl", "$12, %esp"}, kEsp, kEsp, -12},  {{"addl", "$-12, %esp"}, kEsp, kEsp, 12},
      {{"andl", "$-16, %esp"}, kEsp, kEsp, 15},  {{"andl", "$-1, %esp"}, kEsp, kEsp, 0},
      {{"movl", "%esp, %eax"}, 0, kEsp, 0},      {{"movl", "%esp, %ecx"}, 1, kEsp, 0},
      {{"movl", "%edx, %ebx"}, 3, 2, 0},         {{"movl", "%ebp, %esp"}, kEsp, kEbp, 0},
      {{"movl", "%esi, %edi"}, 7, 6, 0},         {{"leal", "-12(%ebp), %esp"}, kEsp, kEbp, 12},
      {{"leal", "(%esp), %ebp"}, kEbp, kEsp, 0}, {{"leal", "4(%esp), %ebp"}, kEbp, kEsp, -4},
  };
  for (const Moves& wanted : cases) {
    expectMoves(x86Stack(wanted.written), wanted);
  }
}

TEST(StackEffectOfX86, SaysNothingOfTheRest) {
  const Written cases[] = {
      {"popl", "%esp"},
      {"subl", "$12, %eax"},
      {"addl", "$12, %eax"},
      {"andl", "$-16, %eax"},
      {"subl", "%eax, %esp"},
      {"andl", "$15, %esp"},
      {"andl", "$0, %esp"},
      {"andl", "$-15, %esp"},
      {"movl", "$4, %esp"},
      {"movl", "4(%eax), %esp"},
      {"movl", "%esp, 4(%eax)"},
      {"leal", "8(%eax,%ebx), %esp"},
      {"leal", "table(%ebp), %esp"},
      {"leal", "4(%esp), %ax"},
      {"leal", "4, %esp"},
      {"xorl", "$4, %esp"},
      {"nop", ""},
      {"incl", "%eax"},
  };
  for (const Written& written : cases) {
    expectMoves(x86Stack(written), {written, kNone, kNone, 0});
  }
}

TEST(StackEffectOfX86, EndsAndCalls) {
  EXPECT_EQ(x86Stack({"retl", ""}).released, 0u);
  EXPECT_EQ(x86Stack({"retl", "$4"}).released, 4u);
  EXPECT_EQ(x86Stack({"pushl", "$4"}).released, 0u);
  for (const char* stops : {"hlt", "ud2"}) {
    EXPECT_TRUE(x86Stack({stops, ""}).stops) << stops;
  }
  EXPECT_FALSE(x86Stack({"retl", ""}).stops);
  EXPECT_TRUE(x86Stack({"calll", "*%gs:16"}).enters_kernel);
  EXPECT_FALSE(x86Stack({"calll", "*%eax"}).enters_kernel);
  EXPECT_FALSE(x86Stack({"jmpl", "*%gs:16"}).enters_kernel);
}

}  // namespace
}  // namespace glider::codegen
