// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// ARM in 32 bits (A32): distances from the program counter, and switches that jump ahead.

#include "codegen/llvm/budget/any_arm.h"
#include "codegen/llvm/budget/operands.h"

#include <llvm/ADT/SmallVector.h>
#include <llvm/Support/Endian.h>

#include <algorithm>
#include <array>
#include <string>

namespace glider::codegen {
namespace {

using llvm::StringRef;

/// Multiplications, which are plain arithmetic. LLVM rejects those with registers that the manual
/// forbids before ARMv6, but the compiler's arithmetic has some that every ARM9 executes correctly.
bool isMultiplication(StringRef bytes) {
  constexpr uint32_t kMask = 0x0F0000F0, kMultiply = 0x00000090;
  return bytes.size() >= 4 && (llvm::support::endian::read32le(bytes.data()) & kMask) == kMultiply;
}

class Arm : public AnyArm {
 public:
  void complete(const Decoded& decoded, Instruction& one) override {
    mention(decoded.written, one);
    choose(decoded.written, one);
  }
  void undecoded(StringRef bytes, Instruction& one) override;
  [[nodiscard]] bool isTrap(StringRef bytes) const override;

 private:
  void mention(const Written& written, Instruction& one) const;
  void choose(const Written& written, Instruction& one);

  std::string compared_;  // "r3" of "cmp r3, #10" immediately before
  int64_t compared_with_ = 0;
  uint64_t compared_at_ = 0;
};

/// The parts of "ldr r3, [pc, #16]", "add r2, pc, r2", "ldr r0, [pc, r3]" and "add r1, pc, #8" that
/// say where something is.
void Arm::mention(const Written& written, Instruction& one) const {
  constexpr uint64_t kAhead = 8;  // of pc
  llvm::SmallVector<StringRef, 4> parts;
  refOf(written.operands).split(parts, ", ");
  const bool loads = written.operation.starts_with("ldr"),
             adds = written.operation.starts_with("add");
  if (parts.size() != 3 || !(loads ? parts[1] == "[pc" : adds && parts[1] == "pc")) {
    return;
  }
  StringRef last = parts[2];
  (void)last.consume_back("]");
  int64_t number = 0;
  if (last.consume_front("#") && !last.getAsInteger(0, number)) {
    one.mentions.numbers[one.mentions.count++] =
        static_cast<uint32_t>(one.address + kAhead + static_cast<uint64_t>(number));
    one.mentions.literal_to = loads ? armRegister(parts[0]) : Mentions::kNone;
  }
  one.mentions.pc_plus = armRegister(last);  // a number is not a register
}

/// How many instructions "cmp r3, #10" and "addls pc, pc, r3, lsl #2" choose from.
void Arm::choose(const Written& written, Instruction& one) {
  const auto [place, number] = refOf(written.operands).split(", #");
  if (one.flow == Flow::JumpAhead || one.flow == Flow::JumpAheadIf) {
    constexpr uint64_t kAhead = 8;
    one.target = one.address + kAhead;
    const bool bounded = written.operation == "addls" && !compared_.empty() &&
                         written.operands == "pc, pc, " + compared_ + ", lsl #2";
    one.choices = bounded ? static_cast<uint64_t>(compared_with_) + 1 : 0;
    one.counted_at = compared_at_;
  }
  compared_.clear();
  if (written.operation == "cmp" && !number.getAsInteger(0, compared_with_) &&
      compared_with_ >= 0) {
    compared_ = place.str();
    compared_at_ = one.address;
  }
}

void Arm::undecoded(StringRef bytes, Instruction& one) {
  one.size = static_cast<uint32_t>(std::min<size_t>(4, bytes.size()));
  one.flow = isMultiplication(bytes) ? Flow::Next : Flow::Unknown;
  one.stack.writes = static_cast<uint16_t>(~(1U << kArmStack.pointer));
  if (isTrap(bytes)) {
    one.flow = Flow::Return;
    one.stack.stops = true;
  }
}

bool Arm::isTrap(StringRef bytes) const {
  constexpr uint32_t kMask = 0xFFF000F0, kTrap = 0xE7F000F0;
  return bytes.size() >= 4 && (llvm::support::endian::read32le(bytes.data()) & kMask) == kTrap;
}

}  // namespace

std::unique_ptr<Architecture> makeArm() {
  return std::make_unique<Arm>();
}

}  // namespace glider::codegen
