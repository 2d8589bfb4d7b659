// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// ARM in 64 bits (A64): where control goes from an instruction, and what it does to the stack.

#include "codegen/llvm/budget/flow_of.h"
#include "codegen/llvm/budget/operands.h"
#include "codegen/llvm/budget/stack_effect.h"

#include <llvm/ADT/SmallVector.h>
#include <llvm/ADT/StringRef.h>

#include <algorithm>
#include <array>
#include <optional>

namespace glider::codegen {
namespace {

using llvm::StringRef;
using Parts = llvm::SmallVector<StringRef, 4>;

bool isOneOf(std::string_view operation, std::initializer_list<std::string_view> names) {
  return std::ranges::find(names, operation) != names.end();
}

/// N of "#N", or of "#N" and "lsl #12".
std::optional<int64_t> shiftedConstantOf(const Parts& parts) {
  const auto number = parts.size() > 2 ? constantOf(parts[2]) : std::nullopt;
  if (!number || parts.size() == 3) {
    return number;
  }
  constexpr int64_t kPage = 4096;
  return parts[3] == "lsl #12" ? std::optional(kPage * *number) : std::nullopt;
}

/// "sp, x29, #8" as x29 less 8: `sign` is 1 if the operation subtracts.
void sum(const Parts& parts, int64_t sign, StackEffect& effect) {
  const auto number = shiftedConstantOf(parts);
  const uint8_t from = number ? aarch64Register(parts[1]) : StackEffect::kNone;
  if (from != StackEffect::kNone) {
    effect.to = aarch64Register(parts[0]);
    effect.from = from;
    effect.bytes = sign * *number;
  }
}

/// "and sp, x0, #0xfffffffffffffff0" rounds down by at most 15.
void roundDown(const Parts& parts, StackEffect& effect) {
  uint64_t mask = 0;
  StringRef text = parts.back();
  const bool known = parts.size() == 3 && text.consume_front("#") && !text.getAsInteger(0, mask);
  const uint64_t most = ~mask;
  constexpr uint64_t kMost = 1 << 16;
  if (known && most < kMost && (most & (most + 1)) == 0) {
    effect.to = aarch64Register(parts[0]);
    effect.from = aarch64Register(parts[1]);
    effect.bytes = static_cast<int64_t>(most);
  }
}

/// "x29, x30, [sp, #-16]!" and "x29, x30, [sp], #16".
void writeBack(StringRef operands, StackEffect& effect) {
  StringRef rest = operands.split('[').second;
  if (rest.consume_front("sp], ") || (rest.consume_front("sp, ") && rest.consume_back("]!"))) {
    if (const auto number = constantOf(rest)) {
      effect.to = effect.from = kAArch64Stack.pointer;
      effect.bytes = -*number;
    }
  }
}

}  // namespace

uint8_t aarch64Register(std::string_view name) {
  unsigned number = 0;
  StringRef text = refOf(name);
  if (text == "sp") {
    return kAArch64Stack.pointer;
  }
  const bool right =
      text.consume_front("x") && !text.getAsInteger(10, number) && number < kAArch64Stack.pointer;
  return right ? static_cast<uint8_t>(number) : StackEffect::kNone;
}

Flow aarch64Flow(const Written& w) {
  if (w.operation == "b") {
    return Flow::Jump;
  }
  if (w.operation.starts_with("b.") || isOneOf(w.operation, {"cbz", "cbnz", "tbz", "tbnz"})) {
    return Flow::JumpIf;
  }
  if (w.operation == "bl") {
    return Flow::Call;
  }
  if (w.operation == "blr") {
    return Flow::CallByPointer;
  }
  if (w.operation == "br") {
    return Flow::JumpByPointer;
  }
  if (w.operation == "ret") {
    return w.operands.empty() ? Flow::Return : Flow::Unknown;
  }
  return isOneOf(w.operation, {"brk", "udf", "hlt"}) ? Flow::Return : Flow::Next;
}

StackEffect aarch64Stack(const Written& written) {
  const StringRef operands = refOf(written.operands);
  Parts parts;
  operands.split(parts, ", ");
  StackEffect effect;
  if (written.operation == "sub" || written.operation == "add") {
    sum(parts, written.operation == "sub" ? 1 : -1, effect);
  } else if (written.operation == "and") {
    roundDown(parts, effect);
  } else if (written.operation == "mov" && parts.size() == 2) {
    effect.from = aarch64Register(parts[1]);
    effect.to = effect.from == StackEffect::kNone ? StackEffect::kNone : aarch64Register(parts[0]);
  } else if (operands.contains("[sp")) {
    writeBack(operands, effect);
  }
  effect.stops = isOneOf(written.operation, {"brk", "udf", "hlt"});
  return effect;
}

}  // namespace glider::codegen
