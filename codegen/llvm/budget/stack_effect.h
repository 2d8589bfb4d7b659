// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>

namespace glider::codegen {

struct Written;

/// What an instruction does to the stack pointer, and to registers that hold where it was.
/// Registers are numbered: of ARM as they are named (sp is 13), of x86 as they are encoded (esp 4).
struct StackEffect {
  static constexpr uint8_t kNone = 255;

  /// False: it changes the stack pointer in a way that nobody can tell.
  bool known = true;
  /// After it, register `to` is `bytes` deeper than `from` was, at most (less than 0: higher).
  uint8_t to = kNone;
  uint8_t from = kNone;
  int64_t bytes = 0;
  /// The registers that it changes otherwise, a bit each.
  uint16_t writes = 0;
  /// ARM's condition, as two letters; empty: it is always carried out.
  char condition[2] = {};
  /// What a return takes off the stack besides the address (x86's "ret $4").
  uint32_t released = 0;
  /// Where the processor stops: nothing comes after it.
  bool stops = false;
  /// A system call by an address that the kernel gives.
  bool enters_kernel = false;

  [[nodiscard]] bool conditional() const { return condition[0] != 0; }
  [[nodiscard]] bool sameCondition(const StackEffect& other) const {
    return condition[0] == other.condition[0] && condition[1] == other.condition[1];
  }
};

/// The registers that matter of a machine.
struct StackMachine {
  uint8_t pointer;        ///< the stack pointer
  uint8_t count;          ///< registers that are numbered
  uint16_t lost;          ///< what a call need not keep, a bit each
  uint32_t call_bytes;    ///< that a call pushes
  uint32_t kernel_bytes;  ///< that a system call by `call *%gs:` takes, its return address included
};
constexpr StackMachine kArmStack = {13, 15, 0x500F, 0, 0};
/// What Linux gives at %gs:16 pushes ecx, edx and ebp before it enters the kernel (2.6 and later).
constexpr StackMachine kX86Stack = {4, 8, 0x0007, 4, 16};

/// By the rules of ARM (A32) and of x86 (32 bits, AT&T's way of writing). `writes` and whether the
/// stack pointer is changed at all are not theirs: Disassembler fills them in.
StackEffect armStack(const Written& written);
StackEffect x86Stack(const Written& written);

}  // namespace glider::codegen
