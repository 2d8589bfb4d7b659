// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/llvm/budget/flow_of.h"

#include <algorithm>
#include <array>

namespace glider::codegen {

bool isArmCondition(std::string_view text) {
  static constexpr std::array<std::string_view, 16> kConditions = {
      "eq", "ne", "hs", "cs", "lo", "cc", "mi", "pl",
      "vs", "vc", "hi", "ls", "ge", "lt", "gt", "le"};
  return std::ranges::find(kConditions, text) != kConditions.end();
}

uint8_t armRegister(llvm::StringRef name) {
  unsigned number = 0;
  if (name == "sp") {
    return 13;
  }
  if (name == "lr") {
    return 14;
  }
  if (name == "pc") {
    return 15;
  }
  const bool right = name.consume_front("r") && !name.getAsInteger(10, number) && number < 13;
  return right ? static_cast<uint8_t>(number) : StackEffect::kNone;
}

namespace {

/// Whether `operation` is `base`, possibly with a condition after it.
bool isPlain(std::string_view operation, std::string_view base) {
  return operation == base;
}
bool isConditional(std::string_view operation, std::string_view base) {
  return operation.starts_with(base) && isArmCondition(operation.substr(base.size()));
}
bool is(std::string_view operation, std::string_view base) {
  return isPlain(operation, base) || isConditional(operation, base);
}

/// ARM's instructions whose destination is the program counter.
Flow armWriteOfPc(const Written& w) {
  const bool conditional =
      w.operation.size() > 3 && isArmCondition(w.operation.substr(w.operation.size() - 2));
  const Flow back = conditional ? Flow::ReturnIf : Flow::Return;
  if (w.operation.starts_with("ldr")) {
    if (w.operands.starts_with("pc, [sp]")) {
      return back;
    }
    return !conditional && w.operands.find("lsl #2]") != std::string_view::npos ? Flow::JumpByTable
                                                                                : Flow::Unknown;
  }
  if (w.operation.starts_with("add") && w.operands.starts_with("pc, pc, r") &&
      w.operands.ends_with(", lsl #2")) {
    return conditional ? Flow::JumpAheadIf : Flow::JumpAhead;
  }
  if (w.operation.starts_with("mov")) {
    return w.operands == "pc, lr" ? back : conditional ? Flow::Unknown : Flow::JumpByPointer;
  }
  return Flow::Unknown;
}

}  // namespace

Flow armFlow(const Written& w) {
  if (is(w.operation, "b")) {
    return isPlain(w.operation, "b") ? Flow::Jump : Flow::JumpIf;
  }
  if (is(w.operation, "bl")) {
    return Flow::Call;
  }
  if (is(w.operation, "blx")) {  // of a number: a call from ARM to Thumb or back
    return w.operands.starts_with('#') ? Flow::Call : Flow::CallByPointer;
  }
  if (is(w.operation, "bx")) {
    const bool conditional = isConditional(w.operation, "bx");
    if (w.operands == "lr") {
      return conditional ? Flow::ReturnIf : Flow::Return;
    }
    return conditional ? Flow::Unknown : Flow::JumpByPointer;
  }
  if (w.operation == "udf" || w.operation == "trap") {
    return Flow::Return;
  }
  const bool many = w.operation.starts_with("ldm") || w.operation.starts_with("pop");
  if (many && w.operands.find("pc") != std::string_view::npos) {
    const bool conditional = isArmCondition(w.operation.substr(w.operation.size() - 2));
    return conditional ? Flow::ReturnIf : Flow::Return;
  }
  // A store or a comparison also has "pc" first, but does not change it.
  const bool reads = w.operation.starts_with("st") || w.operation.starts_with("cmp") ||
                     w.operation.starts_with("cmn") || w.operation.starts_with("t");
  return w.operands.starts_with("pc,") && !reads ? armWriteOfPc(w) : Flow::Next;
}

Flow x86Flow(const Written& w) {
  const bool by_pointer = w.operands.starts_with('*');
  if (w.operation.starts_with("call")) {
    // The C library's system call, at an address that the kernel provides: not code of this
    // program.
    return w.operands.starts_with("*%gs:") ? Flow::Next
           : by_pointer                    ? Flow::CallByPointer
                                           : Flow::Call;
  }
  if (w.operation.starts_with("jmp")) {
    const bool table = by_pointer && w.operands.find("(,") != std::string_view::npos;
    return table ? Flow::JumpByTable : by_pointer ? Flow::JumpByPointer : Flow::Jump;
  }
  if (w.operation.starts_with('j') || w.operation.starts_with("loop")) {
    return Flow::JumpIf;
  }
  const bool ends = w.operation.starts_with("ret") || w.operation == "hlt" || w.operation == "ud2";
  return ends ? Flow::Return : Flow::Next;
}

}  // namespace glider::codegen
