// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// ARM in 64 bits (A64): addresses are made by several instructions, and so are the jumps of
// switches:
//   cmp w8, #10 · b.hi … · adrp x9, … · add x9, x9, … · adr x10, … · ldrb w11, [x9, x8] ·
//   add x10, x10, x11, lsl #2 · br x10
// What each register holds is followed from one instruction to the next.

#include "codegen/llvm/budget/architecture.h"
#include "codegen/llvm/budget/operands.h"

#include <llvm/ADT/SmallVector.h>
#include <llvm/MC/MCInst.h>
#include <llvm/MC/MCInstrDesc.h>
#include <llvm/Support/TargetSelect.h>

#include <array>
#include <optional>

namespace glider::codegen {
namespace {

using llvm::StringRef;
using Parts = llvm::SmallVector<StringRef, 4>;

/// The number of "x3", or of "w3", which is its lower half; kNone for any other.
uint8_t registerOf(StringRef name) {
  const bool half = name.consume_front("w");
  const std::string whole = "x" + name.str();
  return aarch64Register(half ? std::string_view(whole) : std::string_view(name));
}

std::optional<uint64_t> numberIn(StringRef text) {
  const auto number = constantOf(text);
  return number ? std::optional(static_cast<uint64_t>(*number)) : std::nullopt;
}

/// What a register holds, as far as it is known.
struct Value {
  enum class Kind : uint8_t {
    Unknown,
    Number,  ///< `number`
    Entry,   ///< an entry of the table at `number`
    Target   ///< that added to a base
  };
  Kind kind = Kind::Unknown;
  uint64_t number = 0;
  TableEntries entries;
  uint64_t choices = 0;  ///< of an entry; of another value: 1 more than it can be; 0: not known
  uint64_t since = 0;    ///< the first instruction that had a part in it, or in `choices`
};

Value numbered(uint64_t number, uint64_t since) {
  Value value;
  value.kind = Value::Kind::Number;
  value.number = number;
  value.since = since;
  return value;
}

class AArch64 : public Architecture {
 public:
  [[nodiscard]] const StackMachine& stackMachine() const override { return kAArch64Stack; }
  void initialiseDisassembler() const override { LLVMInitializeAArch64Disassembler(); }
  [[nodiscard]] uint8_t numberOf(StringRef name) const override;
  [[nodiscard]] Flow flow(const Written& written) const override { return aarch64Flow(written); }
  [[nodiscard]] StackEffect stack(const Written& written) const override {
    return aarch64Stack(written);
  }
  void complete(const Decoded& decoded, Instruction& one) override;
  void undecoded(StringRef bytes, Instruction& one) override;

 private:
  static constexpr uint64_t kPage = 4096;

  [[nodiscard]] Value valueOf(const Written& written, const Parts& parts,
                              const Instruction& one) const;
  [[nodiscard]] Value loaded(const Parts& parts, uint8_t bytes, StringRef scale,
                             const Instruction& one) const;
  [[nodiscard]] Value copied(const Parts& parts, const Instruction& one) const;
  [[nodiscard]] Value changed(const Parts& parts) const;
  [[nodiscard]] Value sumOf(const Parts& parts, const Instruction& one) const;
  [[nodiscard]] Value held(StringRef name) const;
  void mention(const Written& written, const Parts& parts, const Value& value, Instruction& one);
  void jump(const Parts& parts, Instruction& one) const;
  void compare(const Written& written, const Parts& parts, const Instruction& one);
  void leave(const Instruction& one);
  static void point(const Written& written, const Parts& parts, Instruction& one);

  std::array<Value, 31> values_;  // of x0 to x30
  // Of "cmp w8, #10" immediately before.
  uint8_t compared_ = StackEffect::kNone;
  uint64_t compared_with_ = 0, compared_at_ = 0;
};

uint8_t AArch64::numberOf(StringRef name) const {
  return name == "SP"   ? kAArch64Stack.pointer
         : name == "FP" ? 29
         : name == "LR" ? 30
                        : (name.starts_with("X") ? registerOf(name.lower()) : StackEffect::kNone);
}

Value AArch64::held(StringRef name) const {
  const uint8_t number = registerOf(name);
  return number < values_.size() ? values_[number] : Value{};
}

/// "ldrb w11, [x9, x8]", "ldrh w11, [x9, x8, lsl #1]", "ldrsw x11, [x9, w8, uxtw #2]": an entry of
/// a table, if it is known where that is.
Value AArch64::loaded(const Parts& parts, uint8_t bytes, StringRef scale,
                      const Instruction& one) const {
  StringRef base = parts.size() > 2 ? parts[1] : "", index = parts.size() > 2 ? parts[2] : "",
            extended = parts.size() > 3 ? parts[3] : "";
  (void)(extended.consume_back("]") || index.consume_back("]"));
  const bool wide = extended.consume_front("lsl") || extended.consume_front("uxtw");
  const bool scaled = extended.trim() == scale && (wide || scale.empty());
  const Value table = held(base.drop_front(base.starts_with("[") ? 1 : 0));
  const Value place = held(index);
  if (table.kind != Value::Kind::Number || registerOf(index) == StackEffect::kNone || !scaled) {
    return {};
  }
  const uint64_t since = place.choices > 0 ? std::min(table.since, place.since) : table.since;
  return {.kind = Value::Kind::Entry,
          .number = table.number,
          .entries = {.bytes = bytes},
          .choices = place.choices,
          .since = std::min(since, one.address)};
}

/// "add x8, x8, #16", "add x10, x10, x11, lsl #2", "add x9, x9, x10".
Value AArch64::sumOf(const Parts& parts, const Instruction& one) const {
  const Value base = parts.size() > 2 ? held(parts[1]) : Value{};
  if (base.kind != Value::Kind::Number) {
    return {};
  }
  if (const auto number = numberIn(parts[2])) {
    const bool pages = parts.size() > 3 && parts[3] == "lsl #12";
    const bool known = parts.size() == 3 || pages;
    return known ? numbered(base.number + *number * (pages ? kPage : 1), base.since) : Value{};
  }
  Value sum = held(parts[2]);
  uint64_t shift = 0;
  const auto shifted = parts.size() > 3 ? StringRef(parts[3]).split("lsl #").second : StringRef();
  const bool plain = parts.size() == 3 || !shifted.getAsInteger(10, shift);
  if (sum.kind != Value::Kind::Entry || !plain || !parts[2].starts_with("x")) {
    return {};
  }
  sum.kind = Value::Kind::Target;
  sum.entries.shift = static_cast<uint8_t>(shift);
  sum.entries.base = base.number;
  sum.since = std::min({sum.since, base.since, one.address});
  return sum;
}

/// "mov x8, #16", "mov x8, x9" and, of lower halves, "mov w8, w9".
Value AArch64::copied(const Parts& parts, const Instruction& one) const {
  const auto number = numberIn(parts[1]);
  Value copy = number ? numbered(*number, one.address) : held(parts[1]);
  copy.number &= parts[0].starts_with("w") ? UINT32_MAX : UINT64_MAX;
  return copy;
}

/// "movk x8, #16, lsl #16" changes a quarter of a number.
Value AArch64::changed(const Parts& parts) const {
  constexpr uint64_t kQuarter = 0xFFFF;
  uint64_t shift = 0;
  Value value = held(parts[0]);
  const auto number = numberIn(parts[1]);
  const bool plain =
      parts.size() == 2 || !StringRef(parts[2]).split("lsl #").second.getAsInteger(10, shift);
  if (!number || !plain || value.kind != Value::Kind::Number) {
    return {};
  }
  value.number = (value.number & ~(kQuarter << shift)) | *number << shift;
  return value;
}

/// What the first operand of an instruction holds after it, if it changes that one alone.
Value AArch64::valueOf(const Written& written, const Parts& parts, const Instruction& one) const {
  const std::string_view operation = written.operation;
  if (parts.size() < 2) {
    return {};
  }
  if (operation == "adr" || operation == "adrp") {
    const uint64_t base = operation == "adr" ? one.address : one.address & ~(kPage - 1);
    const auto distance = numberIn(parts[1]);
    return distance ? numbered(base + *distance, one.address) : Value{};
  }
  return operation == "mov"     ? copied(parts, one)
         : operation == "movk"  ? changed(parts)
         : operation == "add"   ? sumOf(parts, one)
         : operation == "ldrb"  ? loaded(parts, 1, "", one)
         : operation == "ldrh"  ? loaded(parts, 2, "#1", one)
         : operation == "ldrsw" ? loaded(parts, 4, "#2", one)
                                : Value{};
}

/// Numbers that may be addresses, and pages of which they are made.
void AArch64::mention(const Written& written, const Parts& parts, const Value& value,
                      Instruction& one) {
  const bool small = value.kind == Value::Kind::Number && value.number <= UINT32_MAX;
  if (small) {
    one.mentions.numbers[0] = static_cast<uint32_t>(value.number);
    one.mentions.count = written.operation == "adrp" ? 0 : 1;
  }
  if (written.operation == "adrp") {
    one.mentions.page_to = registerOf(parts[0]);
  } else if (written.operation == "add" && small) {
    one.mentions.adds_to = registerOf(parts[1]);
  }
}

/// "br x10" of a switch, or where it is known to lead.
void AArch64::jump(const Parts& parts, Instruction& one) const {
  const Value value = held(parts[0]);
  if (value.kind == Value::Kind::Target) {
    one.flow = Flow::JumpByTable;
    one.target = value.number;
    one.entries = value.entries;
    one.choices = value.choices;
    one.counted_at = value.since;
  } else {
    one.pointer = registerOf(parts[0]);
  }
}

/// Follows "cmp w8, #10" and "b.hi": what does not jump has 11 choices.
void AArch64::compare(const Written& written, const Parts& parts, const Instruction& one) {
  const bool bounds = written.operation == "b.hi" && compared_ < values_.size();
  if (bounds && values_[compared_].kind == Value::Kind::Unknown) {
    values_[compared_].choices = compared_with_ + 1;
    values_[compared_].since = compared_at_;
  }
  compared_ = StackEffect::kNone;
  const auto number =
      written.operation == "cmp" && parts.size() == 2 ? numberIn(parts[1]) : std::nullopt;
  if (number && *number < UINT16_MAX) {
    compared_ = registerOf(parts[0]);
    compared_with_ = *number;
    compared_at_ = one.address;
  }
}

/// "ldr x1, [x0, #8]", "ldp x8, x3, [x0]" and "adr x1, #8" give what may be a pointer.
void AArch64::point(const Written& written, const Parts& parts, Instruction& one) {
  const std::string_view operation = written.operation;
  const bool loads =
      operation == "ldr" || operation == "ldp" || operation == "ldur" || operation == "adr";
  for (size_t i = 0; i < parts.size() && loads && !parts[i].starts_with("["); ++i) {
    const uint8_t number = aarch64Register(parts[i]);
    one.pointers |= number < kAArch64Stack.pointer ? 1U << number : 0;
  }
}

/// After a jump nothing is known; a call preserves some registers.
void AArch64::leave(const Instruction& one) {
  const bool calls = one.flow == Flow::Call || one.flow == Flow::CallByPointer;
  const bool goes_on = one.flow == Flow::Next || one.flow == Flow::JumpIf;
  for (uint8_t i = 0; i < values_.size() && !goes_on; ++i) {
    if (!calls || (kAArch64Stack.lost >> i & 1U) != 0) {
      values_[i] = {};
    }
  }
}

void AArch64::complete(const Decoded& decoded, Instruction& one) {
  const Written& written = decoded.written;
  Parts parts;
  refOf(written.operands).split(parts, ", ");
  const bool leads = decoded.about.isBranch() || decoded.about.isCall() || decoded.about.isReturn();
  if (one.flow == Flow::Next && leads) {
    one.flow = Flow::Unknown;  // LLVM knows that it does
  }
  if (one.flow == Flow::JumpByPointer) {
    jump(parts, one);
  }
  point(written, parts, one);
  const Value value = valueOf(written, parts, one);
  mention(written, parts, value, one);
  for (uint8_t i = 0; i < values_.size(); ++i) {
    if ((one.stack.writes >> i & 1U) != 0) {
      values_[i] = registerOf(parts[0]) == i ? value : Value{};
    }
  }
  compare(written, parts, one);
  leave(one);
}

void AArch64::undecoded(StringRef bytes, Instruction& one) {
  one.size = static_cast<uint32_t>(std::min<size_t>(4, bytes.size()));
  one.flow = Flow::Unknown;
  one.stack.writes = ~(1U << kAArch64Stack.pointer);
  values_ = {};
  compared_ = StackEffect::kNone;
}

}  // namespace

std::unique_ptr<Architecture> makeAArch64() {
  return std::make_unique<AArch64>();
}

}  // namespace glider::codegen
