// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "codegen/llvm/budget/stack_effect.h"
#include "platforms/load/board.h"
#include "support/result.h"

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace glider::codegen {

/// Where control goes from an instruction. A conditional one may also continue with the next.
enum class Flow : uint8_t {
  Next,
  Jump,           ///< to `target`
  JumpIf,         ///< to `target` or to the next instruction
  Call,           ///< of `target`, then to the next instruction
  CallByPointer,  ///< then to the next instruction
  JumpByPointer,  ///< to another function, which returns in this one's place
  JumpByTable,    ///< a switch: to where one of the entries from `target` on says
  JumpAhead,      ///< ARM's "add pc, pc, r3, lsl #2": to one of the instructions from `target` on
  JumpAheadIf,    ///< there or to the next instruction
  Return,
  ReturnIf,
  Unknown,  ///< not known
};

/// The addresses that an instruction mentions.
struct Mentions {
  static constexpr uint8_t kNone = 255;
  /// x86: in its operands; ARM: the place that it names, also together with those before it.
  std::array<uint32_t, 3> numbers = {};
  uint8_t count = 0;
  uint8_t literal_to = kNone;  ///< ARM: the register that gets the word at numbers[0]
  uint8_t pc_plus = kNone;     ///< ARM: the register whose distance is added to the place
  uint8_t pc_ahead = 8;        ///< of that, by how much the place that it means is behind it
  /// Thumb: where the word lies that this instruction adds to the stack pointer, from a register
  /// that got it immediately before; 0: none.
  uint64_t stack_word = 0;
  /// ARM in 64 bits: the register that gets the page at numbers[0], and that to which a number is
  /// added, whose sum is numbers[0] if it is known.
  uint8_t page_to = kNone, adds_to = kNone;
  uint32_t registers = 0;  ///< that it uses, a bit each
};

/// What the table of a switch contains.
struct TableEntries {
  uint8_t bytes = 4;          ///< of each entry
  uint8_t shift = 0;          ///< by which it is shifted to the left
  uint64_t base = 0;          ///< to which that is added
  bool from_offsets = false;  ///< to x86's _GLOBAL_OFFSET_TABLE_, and `target` too
  [[nodiscard]] bool distances() const { return from_offsets || base != 0; }
};

struct Instruction {
  uint64_t address = 0;
  uint32_t size = 0;
  Flow flow = Flow::Next;
  uint64_t target = 0;
  /// Upper bound of how often the processor repeats the next instruction (x86's `rep`), if it is 0
  /// or more; kUncounted: not known.
  int64_t repeats = kOnce;
  static constexpr int64_t kOnce = -1, kUncounted = -2;
  uint64_t counted_at = 0;  ///< the instruction that set the count
  /// For JumpAhead and JumpByTable: the number of instructions it chooses from, according to a
  /// comparison at `counted_at` or later; 0: not known.
  uint64_t choices = 0;
  TableEntries entries;  ///< for JumpByTable
  /// ARM in 64 bits, for PointerJumps: the register of a JumpByPointer, and those that an
  /// instruction gives a pointer, a bit each: from memory, or the place that it mentions.
  uint8_t pointer = StackEffect::kNone;
  uint32_t pointers = 0;
  StackEffect stack;
  Mentions mentions;
};

/// The source of an instruction: the function, or one that was inlined there.
struct Frame {
  std::string file;  ///< the file name without folders; empty if unknown
  std::string function;
  uint32_t line = 0;  ///< 0: unknown, or from several places
  bool operator==(const Frame& other) const {
    return file == other.file && function == other.function;
  }
};

/// The linked executable of a board, with its symbols and line tables, disassembled.
class Image {
 public:
  /// For a machine that disassembler.h does not know, code() is empty. GL4004 if the file is not an
  /// ELF file.
  static support::Result<Image> read(const std::string& linked, const platforms::Board& board);
  Image(Image&&) noexcept;
  ~Image();

  /// All code, by address.
  [[nodiscard]] const std::vector<Instruction>& code() const;
  /// The place in code() of the instruction at `address`.
  [[nodiscard]] std::optional<uint32_t> at(uint64_t address) const;
  /// The address at which the program begins.
  [[nodiscard]] uint64_t entry() const;
  /// The address of function `name`.
  [[nodiscard]] std::optional<uint64_t> function(const std::string& name) const;
  /// The addresses of all functions whose names begin with `prefix`.
  [[nodiscard]] std::vector<uint64_t> functionsNamed(const std::string& prefix) const;
  /// The symbol that contains the instruction at `address`; "" if none.
  [[nodiscard]] std::string symbolAt(uint64_t address) const;
  /// Innermost first; at least one.
  [[nodiscard]] std::vector<Frame> framesAt(uint64_t address) const;
  /// Where a switch may go: by the entries of its table, as many as are chosen from, or up to the
  /// first that is not the address of an instruction of the same function. Empty if that is not
  /// known.
  [[nodiscard]] std::vector<uint64_t> tableTargets(const Instruction& jump) const;
  /// The functions whose address may be in a pointer: a loaded word or an operand contains it, or a
  /// distance from where it is used (position-independent code).
  [[nodiscard]] const std::vector<uint64_t>& takenFunctions() const;
  /// All functions of this name: static functions of different files may have the same name.
  [[nodiscard]] std::vector<uint64_t> functionsCalled(const std::string& name) const;
  /// The function's name without namespaces and arguments.
  [[nodiscard]] std::string baseNameAt(uint64_t address) const;
  /// The function's name with namespaces and without arguments: "glider::runtime::InnerSeat::read".
  [[nodiscard]] std::string fullNameAt(uint64_t address) const;
  /// Where the symbol that contains the instruction begins; 0 if there is none.
  [[nodiscard]] uint64_t startOfSymbol(uint64_t address) const;
  /// Where it ends.
  [[nodiscard]] uint64_t endOfSymbol(uint64_t address) const;
  /// Where ARM's `add pc, pc, …` may go: its choices, or everything after it in its function.
  [[nodiscard]] std::vector<uint64_t> aheadTargets(const Instruction& jump) const;
  /// Bytes that are loaded into memory: all of them, and those that are written to.
  [[nodiscard]] uint64_t loadedBytes() const;
  [[nodiscard]] uint64_t writableBytes() const;
  /// The bytes of the mission's context.
  [[nodiscard]] uint64_t contextBytes() const;

 private:
  struct Parts;
  explicit Image(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

}  // namespace glider::codegen
