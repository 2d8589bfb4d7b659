// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "codegen/llvm/budget/image.h"

#include <string_view>

namespace glider::codegen {

/// An instruction as the assembler would write it: "ldrls" and "pc, [sp], #4".
struct Written {
  std::string_view operation;
  std::string_view operands;
};

/// Whether `text` is a condition of ARM, as "ls" of "ldrls".
bool isArmCondition(std::string_view text);

/// Where control goes, by the rules of ARM (A32) and of x86 (32 bits, AT&T's way of writing).
/// Instruction::target is not theirs.
Flow armFlow(const Written& written);
Flow x86Flow(const Written& written);

}  // namespace glider::codegen
