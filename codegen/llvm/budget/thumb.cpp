// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// ARM in 32 bits as Thumb (T32 before Thumb-2): its program counter is 4 ahead and, where a literal
// is loaded, a multiple of 4. What is compiled for it has no tables of switches (-fno-jump-tables).

#include "codegen/llvm/budget/any_arm.h"
#include "codegen/llvm/budget/operands.h"

#include <llvm/ADT/SmallVector.h>

#include <algorithm>
#include <string>

namespace glider::codegen {
namespace {

using llvm::StringRef;

constexpr uint8_t kAhead = 4;  // of pc

class Thumb : public AnyArm {
 public:
  /// "mov pc, r3" is a switch in Thumb: what calls a function in another's place is a `bx`.
  [[nodiscard]] Flow flow(const Written& written) const override {
    return written.operation == "mov" && refOf(written.operands).starts_with("pc,")
               ? Flow::Unknown
               : AnyArm::flow(written);
  }
  void complete(const Decoded& decoded, Instruction& one) override;
  void undecoded(StringRef bytes, Instruction& one) override;

 private:
  void mention(const Written& written, Instruction& one) const;

  Instruction before_;
};

/// "ldr r6, [pc, #16]" and then "add sp, r6" make room that no instruction has as a number.
void Thumb::complete(const Decoded& decoded, Instruction& one) {
  mention(decoded.written, one);
  const bool next = before_.address + before_.size == one.address;
  const uint8_t number = before_.mentions.literal_to;
  if (next && number != Mentions::kNone && decoded.written.operation == "add" &&
      refOf(decoded.written.operands) == "sp, r" + std::to_string(number)) {
    one.mentions.stack_word = before_.mentions.numbers[0];
    one.counted_at = before_.address;
  }
  before_ = one;
}

/// The parts of "ldr r3, [pc, #16]", "adr r0, #8" and "add r2, pc" that say where something is.
void Thumb::mention(const Written& written, Instruction& one) const {
  const StringRef operation = refOf(written.operation);
  llvm::SmallVector<StringRef, 3> parts;
  refOf(written.operands).split(parts, ", ");
  const bool loads = operation == "ldr" && parts.size() == 3 && parts[1] == "[pc";
  if (loads || operation == "adr") {
    StringRef last = parts.back();
    (void)last.consume_back("]");
    const uint64_t from = (one.address + kAhead) & ~uint64_t{3};
    one.mentions.numbers[one.mentions.count++] =
        static_cast<uint32_t>(from + static_cast<uint64_t>(constantOf(last).value_or(0)));
    one.mentions.literal_to = loads ? armRegister(parts[0]) : Mentions::kNone;
  } else if (operation == "add" && parts.size() == 2 && parts[1] == "pc") {
    one.mentions.pc_plus = armRegister(parts[0]);
    one.mentions.pc_ahead = kAhead;
  }
}

void Thumb::undecoded(StringRef bytes, Instruction& one) {
  one.size = static_cast<uint32_t>(std::min<size_t>(2, bytes.size()));
  one.flow = Flow::Unknown;
  one.stack.writes = static_cast<uint16_t>(~(1U << kArmStack.pointer));
  before_ = one;
}

}  // namespace

std::unique_ptr<Architecture> makeThumb() {
  return std::make_unique<Thumb>();
}

}  // namespace glider::codegen
