// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "codegen/llvm/budget/image.h"

#include <string_view>

namespace glider::codegen {

/// An instruction in assembly syntax: "ldrls" and "pc, [sp], #4".
struct Written {
  std::string_view operation;
  std::string_view operands;
};

/// Whether `text` is a condition of ARM, such as "ls" in "ldrls".
bool isArmCondition(std::string_view text);

/// Where control goes, by the rules of ARM (A32) and of x86 (32 bits, AT&T syntax). They do not set
/// Instruction::target.
Flow armFlow(const Written& written);
Flow x86Flow(const Written& written);

}  // namespace glider::codegen
