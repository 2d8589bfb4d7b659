// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What is read off the machine code of small functions: counts, choices, tables, registers.

#include "codegen/llvm/budget/disassembler.h"

#include "tests/unit/codegen/small_program.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace glider::codegen {
namespace {

using codegen_tests::function;
using codegen_tests::Small;

std::vector<Instruction> codeOf(const char* board, const std::string& body) {
  return Small(board, function("_start", body)).image().code();
}

// --- ARM

/// The instruction that chooses, of a switch after `before`.
Instruction chooserAfter(const std::string& before, const std::string& chooser) {
  const auto code = codeOf(
      "ts7800", before + "\n" + chooser + "\n b 3f\n b 1f\n b 2f\n 1: nop\n 2: nop\n 3: bx lr");
  const auto found = std::ranges::find_if(code, [](const Instruction& one) {
    return one.flow == Flow::JumpAheadIf || one.flow == Flow::JumpAhead;
  });
  EXPECT_NE(found, code.end());
  return found == code.end() ? Instruction{} : *found;
}

TEST(DisassemblerOfArm, AComparisonSaysHowManyChoicesThereAre) {
  const std::string chooser = "addls pc, pc, r3, lsl #2";
  const Instruction two = chooserAfter("cmp r3, #1", chooser);
  EXPECT_EQ(two.choices, 2u);
  EXPECT_EQ(two.target, two.address + 8);
  EXPECT_EQ(two.counted_at, two.address - 4);
  EXPECT_EQ(chooserAfter("cmp r3, #0", chooser).choices, 1u);
  EXPECT_EQ(chooserAfter("cmp r3, #200", chooser).choices, 201u);
  for (const char* other :
       {"cmp r2, #1", "cmp r3, r2", "cmp r3, #1\n nop", "cmn r3, #1", "nop", "tst r3, #1"}) {
    EXPECT_EQ(chooserAfter(other, chooser).choices, 0u) << other;
  }
  EXPECT_EQ(chooserAfter("cmp r3, #1", "addlo pc, pc, r3, lsl #2").choices, 0u);
  EXPECT_EQ(chooserAfter("cmp r3, #1", "add pc, pc, r3, lsl #2").choices, 0u);
  EXPECT_EQ(chooserAfter("cmp r3, #1", "add pc, pc, r3, lsl #2").target,
            chooserAfter("cmp r3, #1", "add pc, pc, r3, lsl #2").address + 8);
}

TEST(DisassemblerOfArm, WhatJumpsInBetweenBringsAnotherNumber) {
  const std::string chooser = "addls pc, pc, r3, lsl #2";
  EXPECT_EQ(chooserAfter("b 4f\n 4: cmp r3, #1", chooser).choices, 2u) << "before it";
  EXPECT_EQ(chooserAfter("b 4f\n cmp r3, #1\n 4:", chooser).choices, 0u);
  EXPECT_EQ(chooserAfter("bne 4f\n cmp r3, #1\n 4:", chooser).choices, 0u);
  EXPECT_EQ(chooserAfter("bl 4f\n cmp r3, #1\n 4:", chooser).choices, 0u);
  EXPECT_EQ(chooserAfter("b 3f\n cmp r3, #1\n 4:", chooser).choices, 2u) << "behind it";
}

TEST(DisassemblerOfArm, TheChoicesAreTheNextInstructions) {
  const std::string body =
      "\n addls pc, pc, r3, lsl #2\n b 3f\n b 1f\n b 2f\n 1: nop\n 2: nop\n 3: bx lr";
  const std::string behind = function("behind", "nop\n bx lr");
  const auto targets = [&](const std::string& before) {
    const Small small("ts7800", function("_start", before + body) + behind);
    const auto& code = small.image().code();
    const auto at = std::ranges::find(code, Flow::JumpAheadIf, &Instruction::flow);
    std::vector<uint64_t> found = small.image().aheadTargets(*at);
    for (uint64_t& target : found) {
      target -= at->address;
    }
    return found;
  };
  EXPECT_EQ(targets("cmp r3, #1"), (std::vector<uint64_t>{8, 12}));
  EXPECT_EQ(targets("nop"), (std::vector<uint64_t>{8, 12, 16, 20, 24})) << "to the function's end";
}

TEST(DisassemblerOfArm, NumbersTheRegisters) {
  for (unsigned i = 0; i < 15; ++i) {
    const std::string name = i == 13 ? "sp" : i == 14 ? "lr" : "r" + std::to_string(i);
    const Instruction one = codeOf("ts7800", "add " + name + ", " + name + ", #4\n bx lr").front();
    EXPECT_EQ(one.stack.writes, 1U << i) << name;
    EXPECT_EQ(one.mentions.registers, 1U << i) << name;
  }
  EXPECT_EQ(codeOf("ts7800", "add r1, r2, r3").front().mentions.registers, 0b1110U);
  EXPECT_EQ(codeOf("ts7800", "add r1, r2, r3").front().stack.writes, 0b0010U);
}

TEST(DisassemblerOfArm, ThePointerIsKnownWhereItIsSaidHowItMoves) {
  EXPECT_TRUE(codeOf("ts7800", "sub sp, sp, #4").front().stack.known);
  EXPECT_TRUE(codeOf("ts7800", "sub r0, r0, r1").front().stack.known);
  EXPECT_FALSE(codeOf("ts7800", "sub sp, sp, r1").front().stack.known);
}

TEST(DisassemblerOfArm, SaysWhereThingsLie) {
  const auto code = codeOf("ts7800",
                           "ldr r3, 1f\n add r2, pc, r2\n ldr r0, [pc, r4]\n add r1, pc, #8\n"
                           "ldr r5, [r6, #4]\n sub r7, pc, r7\n bx lr\n 1: .word 77");
  ASSERT_EQ(code.size(), 7u) << "the word is not code";
  EXPECT_EQ(code[0].mentions.count, 1);
  EXPECT_EQ(code[0].mentions.numbers[0], code[0].address + 28);
  EXPECT_EQ(code[0].mentions.literal_to, 3);
  EXPECT_EQ(code[0].mentions.pc_plus, Mentions::kNone);
  EXPECT_EQ(code[1].mentions.pc_plus, 2);
  EXPECT_EQ(code[1].mentions.count, 0);
  EXPECT_EQ(code[2].mentions.pc_plus, 4);
  EXPECT_EQ(code[3].mentions.numbers[0], code[3].address + 16);
  EXPECT_EQ(code[3].mentions.count, 1);
  EXPECT_EQ(code[3].mentions.literal_to, Mentions::kNone);
  for (size_t i = 4; i < 7; ++i) {
    EXPECT_EQ(code[i].mentions.count, 0) << i;
    EXPECT_EQ(code[i].mentions.pc_plus, Mentions::kNone) << i;
    EXPECT_EQ(code[i].mentions.literal_to, Mentions::kNone) << i;
  }
}

TEST(DisassemblerOfArm, TrapsAreCodeEvenAsData) {
  const auto code = codeOf("ts7800", "nop\n .word 0xe7f000f0\n .word 0xe7f000e0\n bx lr");
  ASSERT_EQ(code.size(), 3u);
  EXPECT_TRUE(code[1].stack.stops);
  EXPECT_EQ(code[2].address, code[1].address + 8);
}

TEST(DisassemblerOfArm, WhatIsNotAnInstructionLeadsToAnUnknownPlace) {
  const auto code = codeOf("ts7800", ".inst 0xffffffff\n .inst 0xe0000090\n bx lr");
  ASSERT_EQ(code.size(), 3u);
  EXPECT_EQ(code[0].flow, Flow::Unknown);
  EXPECT_EQ(code[0].size, 4u);
  EXPECT_EQ(code[0].stack.writes, 0xFFFF & ~(1U << 13));
  EXPECT_EQ(code[1].flow, Flow::Next) << "a multiplication";
}

// --- x86

/// How often `rep` repeats after `before`.
int64_t repeatsAfter(const std::string& before) {
  const auto code = codeOf("ts5500", before + "\n rep stosl\n ret");
  const auto found = std::ranges::find_if(
      code, [](const Instruction& one) { return one.repeats != Instruction::kOnce; });
  EXPECT_NE(found, code.end());
  return found == code.end() ? 0 : found->repeats;
}

TEST(DisassemblerOfX86, FollowsTheCountOfRepeats) {
  EXPECT_EQ(repeatsAfter("movl $5, %ecx"), 5);
  EXPECT_EQ(repeatsAfter("movl $0, %ecx"), 0);
  EXPECT_EQ(repeatsAfter("movl $-1, %ecx"), UINT32_MAX) << "it has no sign";
  EXPECT_EQ(repeatsAfter("movl $5, %ecx\n movl $4, %ecx"), 4);
  EXPECT_EQ(repeatsAfter("movl $5, %ecx\n xorl %eax, %eax\n movl $9, %edx"), 5);
  for (const char* before : {"nop", "movl $5, %edx", "movl %eax, %ecx", "movl $5, 4(%ecx)",
                             "movl $5, %ecx\n incl %ecx", "movl $5, %ecx\n movw %ax, %cx",
                             "movl $5, %ecx\n movb %al, %cl", "movl $5, %ecx\n movb %al, %ch",
                             "movl $5, %ecx\n call 9f\n 9:", "movl $5, %ecx\n rep movsl\n",
                             "jmp 9f\n movl $5, %ecx\n 9:", "jne 9f\n movl $5, %ecx\n 9: nop"}) {
    if (std::string(before).find("rep") == std::string::npos) {
      EXPECT_EQ(repeatsAfter(before), Instruction::kUncounted) << before;
    } else {
      const auto code = codeOf("ts5500", std::string(before) + "rep stosl\n ret");
      EXPECT_EQ(std::ranges::count(code, Instruction::kUncounted, &Instruction::repeats), 1);
      EXPECT_EQ(std::ranges::count(code, 5, &Instruction::repeats), 1);
    }
  }
}

TEST(DisassemblerOfX86, NumbersTheRegisters) {
  const char* const names[] = {"eax", "ecx", "edx", "ebx", "esp", "ebp", "esi", "edi"};
  for (unsigned i = 0; i < 8; ++i) {
    const Instruction one = codeOf("ts5500", std::string("movl $5, %") + names[i]).front();
    EXPECT_EQ(one.stack.writes, 1U << i) << names[i];
    EXPECT_EQ(one.mentions.registers, 1U << i) << names[i];
    EXPECT_EQ(one.stack.known, i != 4) << names[i];
    EXPECT_EQ(one.mentions.count, 1);
    EXPECT_EQ(one.mentions.numbers[0], 5u);
  }
  EXPECT_TRUE(codeOf("ts5500", "pushl %eax").front().stack.known);
  EXPECT_TRUE(codeOf("ts5500", "call *%gs:16").front().stack.known);
  EXPECT_TRUE(codeOf("ts5500", "ret").front().stack.known);
}

/// Where the switch of `_start` goes, as distances from its beginning.
std::vector<uint64_t> switchOf(const std::string& assembly) {
  const Small small("ts5500", assembly);
  const auto& code = small.image().code();
  const auto at = std::ranges::find(code, Flow::JumpByTable, &Instruction::flow);
  if (at == code.end()) {
    return {};
  }
  std::vector<uint64_t> targets = small.image().tableTargets(*at);
  for (uint64_t& target : targets) {
    target -= small.image().entry();
  }
  return targets;
}

TEST(DisassemblerOfX86, ATableHoldsPlacesOfItsFunction) {
  const std::string body = function("_start", "jmp *table(,%eax,4)\n 1: nop\n 2: nop\n ret");
  const auto targets = [&](const std::string& rows) {
    return switchOf(function("before", "ret") + body + function("behind", "ret") +
                    ".section .rodata\n .align 4\n table: " + rows);
  };
  EXPECT_EQ(targets(".long 1b, 2b, behind, 1b"), (std::vector<uint64_t>{7, 8}));
  EXPECT_EQ(targets(".long _start, before"), std::vector<uint64_t>{0});
  EXPECT_EQ(targets(".long 2b, before, 1b"), std::vector<uint64_t>{8});
  EXPECT_EQ(targets(".long 1b, 2b"), (std::vector<uint64_t>{7, 8})) << "to the segment's end";
  EXPECT_EQ(targets(".long 1b, _start + 1"), std::vector<uint64_t>{7}) << "no instruction";
  EXPECT_TRUE(switchOf(function("_start", "jmp *table(,%eax,8)\n 1: ret") +
                       ".section .rodata\n table: .long 1b")
                  .empty());
}

TEST(DisassemblerOfX86, ATableMayHoldDistances) {
  const std::string table = ".section .rodata\n .align 4\n table: .long 1b@GOTOFF, 2b@GOTOFF, 0";
  const auto targets = [&](const std::string& way) {
    return switchOf(function("_start",
                             "call 9f\n 9: popl %ebx\n"
                             "addl $_GLOBAL_OFFSET_TABLE_+(.-9b), %ebx\n" +
                                 way + "\n nop\n 1: nop\n 2: ret") +
                    table);
  };
  const std::string load = "movl table@GOTOFF(%ebx,%ecx,4), %ecx\n ", add = "addl %ebx, %ecx\n ",
                    jump = "jmp *%ecx";
  const auto found = targets(load + add + jump);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[1], found[0] + 1);
  for (const std::string& way :
       {load + jump, add + jump, load + add + "nop\n " + jump, load + "nop\n " + add + jump,
        load + add + "jmp *%edx", load + "addl %edx, %ecx\n " + jump,
        load + "subl %ebx, %ecx\n " + jump, "leal table@GOTOFF(%ebx,%ecx,4), %ecx\n " + add + jump,
        "jmp 8f\n " + load + "8: " + add + jump, "jmp 8f\n " + load + add + "8: " + jump}) {
    EXPECT_TRUE(targets(way).empty()) << way;
  }
}

TEST(Images, KnowWhereFunctionsBeginAndEnd) {
  const Small small("ts5500", function("_start", "nop\n call after\n ret") + ".align 16, 0x90\n" +
                                  function("after", "nop\n ret") +
                                  ".comm gliderContextMemory, 1234, 8\n");
  const Image& image = small.image();
  const uint64_t start = image.entry(), after = *image.function("after");
  EXPECT_EQ(image.startOfSymbol(start + 6), start);
  EXPECT_EQ(image.endOfSymbol(start + 6), start + 7);
  EXPECT_EQ(image.symbolAt(start + 6), "_start");
  EXPECT_EQ(image.symbolAt(start + 7), "") << "what fills up is of no function";
  EXPECT_EQ(image.startOfSymbol(start + 7), 0u);
  EXPECT_EQ(image.endOfSymbol(start + 7), 0u);
  EXPECT_EQ(image.symbolAt(start - 1), "");
  EXPECT_EQ(image.symbolAt(after), "after");
  EXPECT_EQ(image.endOfSymbol(after + 1), after + 2);
  EXPECT_EQ(image.contextBytes(), 1234u);
  EXPECT_FALSE(image.at(start + 2)) << "within the call";
  EXPECT_EQ(image.code().at(*image.at(start + 1)).target, after);
  EXPECT_FALSE(image.function("none"));
}

TEST(Images, CountWhatIsLoaded) {
  const auto small = [](const std::string& data) {
    return Small("ts5500", function("_start", "ret") + data);
  };
  const Small plain = small(""), more = small(".data\n .space 1000\n .bss\n .space 300\n");
  EXPECT_EQ(plain.image().writableBytes(), 0u);
  EXPECT_GE(more.image().writableBytes(), 1300u);
  EXPECT_LT(more.image().writableBytes(), 1310u);
  EXPECT_GE(more.image().loadedBytes(), plain.image().loadedBytes() + 1300);
}

}  // namespace
}  // namespace glider::codegen
