// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "codegen/llvm/budget/image.h"

#include <llvm/ADT/StringRef.h>

#include <cstdint>
#include <memory>

namespace llvm {
class MCInst;
class MCInstrDesc;
class Triple;
}  // namespace llvm

namespace glider::codegen {

/// The registers of a board's machine, one that Disassembler::knows.
const StackMachine& stackMachine(const platforms::Board& board);

/// How instructions are encoded: as the board's triple says, or on ARM in 32 bits as Thumb.
enum class Encoding : uint8_t { Usual, Thumb };

/// Machine code of one board, instruction by instruction.
class Disassembler {
 public:
  /// GL4002 for a machine that it does not know: it knows x86 and ARM in 32 bits, and ARM in 64.
  static support::Result<std::unique_ptr<Disassembler>> make(const platforms::Board& board);
  ~Disassembler();
  /// Whether make() knows the machine.
  static bool knows(const platforms::Board& board);

  /// The instruction at the beginning of `bytes`, which must not be empty; one of Flow::Unknown if
  /// they are not a valid instruction. Must be called in the order of the code.
  Instruction read(llvm::StringRef bytes, uint64_t address, Encoding encoding);

  /// Architecture::isTrap.
  [[nodiscard]] bool isTrap(llvm::StringRef bytes) const;

 private:
  struct Machine;
  struct Reader;
  explicit Disassembler(std::unique_ptr<Machine> machine);
  static Reader readerOf(const platforms::Board& board, const llvm::Triple& triple,
                         const Machine& machine);
  [[nodiscard]] uint32_t writtenBy(const llvm::MCInst& inst, const llvm::MCInstrDesc& about) const;

  std::unique_ptr<Machine> machine_;
};

}  // namespace glider::codegen
