// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/llvm/budget/stack_effect.h"

#include "codegen/llvm/budget/flow_of.h"
#include "codegen/llvm/budget/operands.h"

#include <llvm/ADT/SmallVector.h>
#include <llvm/ADT/StringRef.h>

#include <algorithm>
#include <array>
#include <optional>

namespace glider::codegen {
namespace {

using llvm::StringRef;

constexpr int64_t kWord = 4;

// --- ARM

/// How many registers "{r4, r5, lr}" holds; LLVM writes no ranges.
std::optional<int64_t> listed(StringRef operands) {
  const auto [before, list] = operands.split('{');
  const bool closed = list.ends_with("}") && !list.contains('-');
  return closed ? std::optional(static_cast<int64_t>(list.count(',') + 1)) : std::nullopt;
}

/// How many bytes "{d8, d9}" or "{s16}" holds.
std::optional<int64_t> listedOfVfp(StringRef operands) {
  const auto count = listed(operands);
  const int64_t size = operands.starts_with("{d") ? 2 * kWord : kWord;
  return count ? std::optional(size * *count) : std::nullopt;
}

struct Operation {
  StringRef base;
  StringRef condition;  ///< two letters, or empty
};

Operation armOperation(StringRef operation) {
  static constexpr std::array<std::string_view, 19> kBases = {
      "push", "pop", "vpush", "vpop", "stmdb", "ldm",  "sub", "subs", "add", "adds",
      "bic",  "mov", "str",   "ldr",  "strd",  "ldrd", "bl",  "blx",  "bx"};
  for (const std::string_view base : kBases) {
    StringRef rest = operation;
    if (rest.consume_front(refOf(base)) && (rest.empty() || isArmCondition(rest))) {
      return {refOf(base), rest};
    }
  }
  return {};
}

/// "sp, r11, #8" as r11 less 8, and Thumb's "sp, #8" as sp less 8: `sign` is 1 if the operation
/// subtracts.
void armSum(const llvm::SmallVectorImpl<StringRef>& parts, int64_t sign, StackEffect& effect) {
  if (parts.size() < 2 || parts.size() > 3) {
    return;
  }
  const auto number = constantOf(parts.back());
  const uint8_t to = armRegister(parts[0]);
  const uint8_t from = armRegister(parts[parts.size() - 2]);
  if (number && to < 15 && from < 15) {
    effect.to = to;
    effect.from = from;
    effect.bytes = sign * *number;
  }
}

/// "bic sp, r0, #15" rounds down by at most 15.
void armRound(const llvm::SmallVectorImpl<StringRef>& parts, StackEffect& effect) {
  armSum(parts, 1, effect);
  const bool mask = effect.bytes >= 0 && (effect.bytes & (effect.bytes + 1)) == 0;
  effect.to = mask ? effect.to : StackEffect::kNone;
}

void moveSp(std::optional<int64_t> bytes, StackEffect& effect) {
  if (bytes) {
    effect.to = effect.from = kArmStack.pointer;
    effect.bytes = *bytes;
  }
}

/// "str lr, [sp, #-8]!" and "ldr pc, [sp], #8", with one register or two.
void armWriteBack(StringRef operands, StackEffect& effect) {
  const auto [registers, place] = operands.split('[');
  StringRef rest = place;
  if (registers.contains("sp")) {
    return;
  }
  if (rest.consume_front("sp], ") || (rest.consume_front("sp, ") && rest.consume_back("]!"))) {
    const auto number = constantOf(rest);
    moveSp(number ? std::optional(-*number) : std::nullopt, effect);
  }
}

// --- x86

uint8_t x86Register(StringRef name) {
  static constexpr std::array<std::string_view, 8> kNames = {"%eax", "%ecx", "%edx", "%ebx",
                                                             "%esp", "%ebp", "%esi", "%edi"};
  const auto found = std::ranges::find(kNames, std::string_view(name.data(), name.size()));
  return found == kNames.end() ? StackEffect::kNone : static_cast<uint8_t>(found - kNames.begin());
}

void moveEsp(int64_t bytes, StackEffect& effect) {
  effect.to = effect.from = kX86Stack.pointer;
  effect.bytes = bytes;
}

/// "leal -12(%ebp), %esp".
void x86Address(StringRef source, uint8_t to, StackEffect& effect) {
  const auto [offset, base] = source.split('(');
  int64_t number = 0;
  const bool right = base.ends_with(")") && (offset.empty() || !offset.getAsInteger(0, number));
  const uint8_t from = right ? x86Register(base.drop_back()) : StackEffect::kNone;
  if (from != StackEffect::kNone && to != StackEffect::kNone) {
    effect.to = to;
    effect.from = from;
    effect.bytes = -number;
  }
}

/// "subl $12, %esp" and other operations with two operands.
void x86Two(StringRef operation, StringRef source, uint8_t to, StackEffect& effect) {
  const auto number = constantOf(source);
  const bool pointer = to == kX86Stack.pointer && number;
  if (operation == "subl" && pointer) {
    moveEsp(*number, effect);
  } else if (operation == "addl" && pointer) {
    moveEsp(-*number, effect);
  } else if (operation == "andl" && pointer && *number < 0 && (-*number & (-*number - 1)) == 0) {
    moveEsp(-*number - 1, effect);
  } else if (operation == "movl") {
    effect.from = x86Register(source);
    effect.to = effect.from == StackEffect::kNone ? StackEffect::kNone : to;
  } else if (operation == "leal") {
    x86Address(source, to, effect);
  }
}

}  // namespace

StackEffect armStack(const Written& written) {
  const StringRef operands = refOf(written.operands);
  const Operation operation = armOperation(refOf(written.operation));
  StackEffect effect;
  llvm::SmallVector<StringRef, 4> parts;
  operands.split(parts, ", ");
  if (operation.base == "push" || (operation.base == "stmdb" && parts[0] == "sp!")) {
    const auto count = listed(operands);
    moveSp(count ? std::optional(kWord * *count) : std::nullopt, effect);
  } else if (operation.base == "pop" || (operation.base == "ldm" && parts[0] == "sp!")) {
    // With sp in the list its new value would come from memory.
    const auto count = operands.split('{').second.contains("sp") ? std::nullopt : listed(operands);
    moveSp(count ? std::optional(-kWord * *count) : std::nullopt, effect);
  } else if (operation.base == "vpush" || operation.base == "vpop") {
    const auto bytes = listedOfVfp(operands);
    const int64_t sign = operation.base == "vpush" ? 1 : -1;
    moveSp(bytes ? std::optional(sign * *bytes) : std::nullopt, effect);
  } else if (operation.base.starts_with("sub") || operation.base.starts_with("add")) {
    armSum(parts, operation.base.starts_with("sub") ? 1 : -1, effect);
  } else if (operation.base == "bic") {
    armRound(parts, effect);
  } else if (operation.base == "mov" && parts.size() == 2 && armRegister(parts[1]) < 15) {
    effect.to = armRegister(parts[0]);
    effect.from = armRegister(parts[1]);
  } else if (operands.contains("[sp")) {
    armWriteBack(operands, effect);
  }
  effect.to = effect.to < 15 ? effect.to : StackEffect::kNone;
  std::ranges::copy(operation.condition, effect.condition);
  effect.stops = written.operation == "udf" || written.operation == "trap";
  return effect;
}

StackEffect x86Stack(const Written& written) {
  const StringRef operation = refOf(written.operation), operands = refOf(written.operands);
  StackEffect effect;
  if (operation == "pushl" || operation == "pushfl") {
    moveEsp(kWord, effect);
  } else if ((operation == "popl" && operands != "%esp") || operation == "popfl") {
    moveEsp(-kWord, effect);
  } else if (operation == "pushal" || operation == "popal") {
    moveEsp(operation == "pushal" ? 8 * kWord : -8 * kWord, effect);
  } else if (operation == "leave") {
    moveEsp(-kWord, effect);
    effect.from = 5;  // ebp
  } else if (operation.starts_with("ret")) {
    effect.released = static_cast<uint32_t>(constantOf(operands).value_or(0));
  } else if (const size_t comma = operands.rfind(", "); comma != StringRef::npos) {
    x86Two(operation, operands.take_front(comma), x86Register(operands.drop_front(comma + 2)),
           effect);
  }
  effect.stops = operation == "hlt" || operation == "ud2";
  effect.enters_kernel = operation.starts_with("call") && operands.starts_with("*%gs:");
  return effect;
}

}  // namespace glider::codegen
