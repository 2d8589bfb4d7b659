// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "codegen/llvm/budget/image.h"

#include <llvm/ADT/StringRef.h>

#include <string_view>

namespace glider::codegen {

/// An instruction in assembly syntax: "ldrls" and "pc, [sp], #4".
struct Written {
  std::string_view operation;
  std::string_view operands;
};

/// Whether `text` is a condition of ARM, such as "ls" in "ldrls".
bool isArmCondition(std::string_view text);
/// The number of "x3" or "sp" on ARM in 64 bits, by StackEffect; kNone for any other.
uint8_t aarch64Register(std::string_view name);
/// The number of "r3", "sp", "lr" or "pc" on ARM in 32 bits, by StackEffect; kNone for any other.
uint8_t armRegister(llvm::StringRef name);

/// Where control goes, by the rules of ARM (A32, T32), of x86 (32 bits, AT&T syntax) and of ARM in
/// 64 bits (A64). They do not set Instruction::target.
Flow armFlow(const Written& written);
Flow x86Flow(const Written& written);
Flow aarch64Flow(const Written& written);

}  // namespace glider::codegen
