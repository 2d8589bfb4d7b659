// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// x86 in 32 bits: counts of `rep`, numbers among the operands, and switches by distances.

#include "codegen/llvm/budget/architecture.h"
#include "codegen/llvm/budget/operands.h"

#include <llvm/MC/MCInst.h>
#include <llvm/Support/TargetSelect.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>

namespace glider::codegen {
namespace {

using llvm::StringRef;

/// N of "movl $N, %ecx"; empty for any other instruction.
std::optional<int64_t> countSetBy(const Written& written) {
  const std::string_view operands = written.operands;
  constexpr std::string_view kTo = ", %ecx";
  int64_t number = 0;
  if (written.operation != "movl" || !operands.starts_with('$') || !operands.ends_with(kTo)) {
    return std::nullopt;
  }
  const std::string_view text = operands.substr(1, operands.size() - 1 - kTo.size());
  const bool whole = !StringRef(text.data(), text.size()).getAsInteger(0, number);
  return whole && number >= 0 ? std::optional(number) : std::nullopt;
}

/// The address in "*4197908(,%esi,4)"; 0 if there is none.
uint64_t tableOf(const Written& written) {
  uint64_t address = 0;
  StringRef text = refOf(written.operands);
  text.consume_front("*");
  const bool wrong = text.take_until([](char c) { return c == '('; }).getAsInteger(0, address);
  return wrong || !text.ends_with(",4)") ? 0 : address;
}

class X86 : public Architecture {
 public:
  [[nodiscard]] const StackMachine& stackMachine() const override { return kX86Stack; }
  void initialiseDisassembler() const override { LLVMInitializeX86Disassembler(); }
  [[nodiscard]] uint8_t numberOf(StringRef name) const override;
  [[nodiscard]] Flow flow(const Written& written) const override { return x86Flow(written); }
  [[nodiscard]] StackEffect stack(const Written& written) const override {
    return x86Stack(written);
  }
  void complete(const Decoded& decoded, Instruction& one) override;
  void undecoded(StringRef bytes, Instruction& one) override;

 private:
  void count(const Written& written, Instruction& one);
  void switchByDistance(const Written& written, Instruction& one);

  std::optional<int64_t> count_;  // the value of ecx
  uint64_t counted_at_ = 0;
  /// From "movl -8(%ebx,%ecx,4), %ecx", "addl %ebx, %ecx" immediately before: used by the next
  /// jump.
  std::string added_, jumps_by_;
  int64_t table_ = 0;
  uint64_t table_at_ = 0;
};

uint8_t X86::numberOf(StringRef name) const {
  static constexpr std::array<std::string_view, 8> kNames = {"EAX", "ECX", "EDX", "EBX",
                                                             "ESP", "EBP", "ESI", "EDI"};
  const auto found = std::ranges::find(kNames, std::string_view(name.data(), name.size()));
  return found == kNames.end() ? StackEffect::kNone : static_cast<uint8_t>(found - kNames.begin());
}

void X86::complete(const Decoded& decoded, Instruction& one) {
  for (const llvm::MCOperand& operand : decoded.inst) {
    if (operand.isImm() && one.mentions.count < one.mentions.numbers.size()) {
      one.mentions.numbers[one.mentions.count++] = static_cast<uint32_t>(operand.getImm());
    }
  }
  count(decoded.written, one);
  switchByDistance(decoded.written, one);
  if (one.flow == Flow::JumpByTable && !one.entries.from_offsets) {
    one.target = tableOf(decoded.written);
  }
  // A return, a call and a system call leave the pointer where it was.
  one.stack.known = one.stack.known || one.stack.enters_kernel || one.flow != Flow::Next;
}

/// Follows ecx from instruction to instruction, for `rep`.
void X86::count(const Written& written, Instruction& one) {
  constexpr std::array<std::string_view, 4> kNames = {"ecx", "%cx", "%cl", "%ch"};
  if (written.operation.starts_with("rep")) {
    one.repeats = count_.value_or(Instruction::kUncounted);
    one.counted_at = counted_at_;
    count_.reset();
    return;
  }
  if (const auto set = countSetBy(written)) {
    count_ = set;
    counted_at_ = one.address;
    return;
  }
  const bool touches = std::ranges::any_of(kNames, [&](std::string_view name) {
    return written.operands.find(name) != std::string_view::npos;
  });
  if (touches || one.flow != Flow::Next) {
    count_.reset();
  }
}

/// Switches in position-independent code: their tables contain distances.
void X86::switchByDistance(const Written& written, Instruction& one) {
  const StringRef operands = refOf(written.operands);
  if (written.operation == "jmpl" && !jumps_by_.empty() && operands == jumps_by_) {
    one.flow = Flow::JumpByTable;
    one.entries.from_offsets = true;
    one.target = static_cast<uint32_t>(table_);
    one.counted_at = table_at_;
  }
  jumps_by_.clear();
  if (written.operation == "addl" && !added_.empty() && operands == added_) {
    jumps_by_ = "*" + operands.take_back(4).str();
  }
  added_.clear();
  // "-8(%ebx,%ecx,4), %ecx"
  const auto [place, to] = operands.split(",4), ");
  const auto [offset, registers] = place.split('(');
  if (written.operation == "movl" && to.size() == 4 && !offset.getAsInteger(0, table_)) {
    added_ = (registers.split(',').first + ", " + to).str();
    table_at_ = one.address;
  }
}

void X86::undecoded(StringRef /*bytes*/, Instruction& one) {
  one.size = 1;
  one.flow = Flow::Unknown;
  one.stack.writes = static_cast<uint16_t>(~(1U << kX86Stack.pointer));
}

}  // namespace

std::unique_ptr<Architecture> makeX86() {
  return std::make_unique<X86>();
}

}  // namespace glider::codegen
