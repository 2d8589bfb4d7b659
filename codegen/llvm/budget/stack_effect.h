// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>

namespace glider::codegen {

struct Written;

/// The effect of an instruction on the stack pointer, and on registers that hold an earlier value
/// of it. Registers are numbered: on ARM as they are named (sp is 13), on x86 as they are encoded
/// (esp 4), on ARM in 64 bits as they are named (x30 is 30, sp 31).
struct StackEffect {
  static constexpr uint8_t kNone = 255;

  /// False: it changes the stack pointer in an unknown way.
  bool known = true;
  /// After it, register `to` is at most `bytes` deeper than `from` was (less than 0: higher).
  uint8_t to = kNone;
  uint8_t from = kNone;
  int64_t bytes = 0;
  /// The registers that it changes in another way, a bit each.
  uint32_t writes = 0;
  /// ARM's condition, as two letters; empty: it is always executed.
  char condition[2] = {};
  /// What a return takes off the stack in addition to the address (x86's "ret $4").
  uint32_t released = 0;
  /// Whether the program stops here: nothing follows.
  bool stops = false;
  /// Whether it is a system call by an address that the kernel provides.
  bool enters_kernel = false;

  [[nodiscard]] bool conditional() const { return condition[0] != 0; }
  [[nodiscard]] bool sameCondition(const StackEffect& other) const {
    return condition[0] == other.condition[0] && condition[1] == other.condition[1];
  }
};

/// The registers of a machine that affect the stack.
struct StackMachine {
  uint8_t pointer;        ///< the stack pointer
  uint8_t count;          ///< registers that are numbered
  uint32_t lost;          ///< registers that a call need not preserve, a bit each
  uint32_t call_bytes;    ///< that a call pushes
  uint32_t kernel_bytes;  ///< by a system call with `call *%gs:`, including its return address
};
constexpr StackMachine kArmStack = {13, 15, 0x500F, 0, 0};
/// The code that Linux provides at %gs:16 pushes ecx, edx and ebp before it enters the kernel (2.6
/// and later).
constexpr StackMachine kX86Stack = {4, 8, 0x0007, 4, 16};
/// A call preserves x19 to x29.
constexpr StackMachine kAArch64Stack = {31, 32, 0x4007FFFF, 0, 0};

/// By the rules of ARM (A32, T32), of x86 (32 bits, AT&T syntax) and of ARM in 64 bits (A64). They
/// do not set `writes`, or whether the stack pointer is changed at all: Disassembler does that.
StackEffect armStack(const Written& written);
StackEffect x86Stack(const Written& written);
StackEffect aarch64Stack(const Written& written);

}  // namespace glider::codegen
