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

/// Where control goes from an instruction. What a condition guards may also go on to the next one.
enum class Flow : uint8_t {
  Next,
  Jump,           ///< to `target`
  JumpIf,         ///< to `target` or on
  Call,           ///< of `target`, then on
  CallByPointer,  ///< then on
  JumpByPointer,  ///< to another function for good, on its behalf
  JumpByTable,    ///< a switch: to one of the words from `target` on
  JumpAhead,      ///< ARM's "add pc, pc, r3, lsl #2": to one of the instructions from `target` on
  JumpAheadIf,    ///< there or on
  Return,
  ReturnIf,
  Unknown,  ///< nobody can tell
};

/// What an instruction says of addresses.
struct Mentions {
  static constexpr uint8_t kNone = 255;
  std::array<uint32_t, 3> numbers = {};  ///< x86: in its operands; ARM: the place that it names
  uint8_t count = 0;
  uint8_t literal_to = kNone;  ///< ARM: the register that gets the word at numbers[0]
  uint8_t pc_plus = kNone;     ///< ARM: the register whose distance is added to the place
  uint16_t registers = 0;      ///< that it has to do with, a bit each
};

struct Instruction {
  uint64_t address = 0;
  uint32_t size = 0;
  Flow flow = Flow::Next;
  uint64_t target = 0;
  /// The next instruction is repeated by the processor (x86's `rep`), so often at most if it is 0
  /// or more; kUncounted: nobody can tell.
  int64_t repeats = kOnce;
  static constexpr int64_t kOnce = -1, kUncounted = -2;
  uint64_t counted_at = 0;  ///< the instruction that set the count
  /// Of JumpAhead: how many instructions it chooses from, of which a comparison at `counted_at`
  /// tells; 0: nobody can tell.
  uint64_t choices = 0;
  /// Of JumpByTable: the table holds distances from x86's _GLOBAL_OFFSET_TABLE_, as `target` is
  /// one.
  bool by_distance = false;
  StackEffect stack;
  Mentions mentions;
};

/// Where in the sources an instruction comes from: the function, or one that was inlined there.
struct Frame {
  std::string file;  ///< its last part; empty if unknown
  std::string function;
  uint32_t line = 0;  ///< 0: unknown, or of several places
  bool operator==(const Frame& other) const {
    return file == other.file && function == other.function;
  }
};

/// The linked executable of a board, with its symbols and line tables, taken apart.
class Image {
 public:
  /// Of a machine that disassembler.h does not know, code() is empty. GL4004 if it is no ELF file.
  static support::Result<Image> read(const std::string& linked, const platforms::Board& board);
  Image(Image&&) noexcept;
  ~Image();

  /// All code, by address.
  [[nodiscard]] const std::vector<Instruction>& code() const;
  /// The place in code() of the instruction at `address`.
  [[nodiscard]] std::optional<uint32_t> at(uint64_t address) const;
  /// Where the program begins.
  [[nodiscard]] uint64_t entry() const;
  /// The address of function `name`.
  [[nodiscard]] std::optional<uint64_t> function(const std::string& name) const;
  /// The addresses of all functions whose names begin with `prefix`.
  [[nodiscard]] std::vector<uint64_t> functionsNamed(const std::string& prefix) const;
  /// The symbol that the instruction at `address` belongs to; "" if none.
  [[nodiscard]] std::string symbolAt(uint64_t address) const;
  /// Innermost first; at least one.
  [[nodiscard]] std::vector<Frame> framesAt(uint64_t address) const;
  /// Where a switch may go: what its table holds, up to the first word that is no instruction of
  /// the same function. Empty if nobody can tell.
  [[nodiscard]] std::vector<uint64_t> tableTargets(const Instruction& jump) const;
  /// The functions whose address may be in a pointer: a loaded word or an operand holds it, or a
  /// distance from where it is used (code that may lie anywhere).
  [[nodiscard]] const std::vector<uint64_t>& takenFunctions() const;
  /// All functions of this name: a file's own may have the name of another's.
  [[nodiscard]] std::vector<uint64_t> functionsCalled(const std::string& name) const;
  /// The function's name without namespaces and arguments.
  [[nodiscard]] std::string baseNameAt(uint64_t address) const;
  /// Where the instruction's symbol begins; 0 if it has none.
  [[nodiscard]] uint64_t startOfSymbol(uint64_t address) const;
  /// Where it ends.
  [[nodiscard]] uint64_t endOfSymbol(uint64_t address) const;
  /// Where ARM's `add pc, pc, …` may go: its choices, or whatever comes after it in its function.
  [[nodiscard]] std::vector<uint64_t> aheadTargets(const Instruction& jump) const;
  /// Of what is loaded into memory: all of it, and what is written to.
  [[nodiscard]] uint64_t loadedBytes() const;
  [[nodiscard]] uint64_t writableBytes() const;
  /// Of the mission's context.
  [[nodiscard]] uint64_t contextBytes() const;

 private:
  struct Parts;
  explicit Image(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

}  // namespace glider::codegen
