// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "codegen/llvm/budget/flow_of.h"
#include "codegen/llvm/budget/image.h"

#include <llvm/ADT/StringRef.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace llvm {
class MCInst;
}

namespace glider::codegen {

/// The registers of a board's machine, one that Disassembler::knows.
const StackMachine& stackMachine(const platforms::Board& board);

/// Machine code of one board, instruction by instruction.
class Disassembler {
 public:
  /// GL4002 for a machine that it does not know: 32-bit x86 and ARM are known.
  static support::Result<std::unique_ptr<Disassembler>> make(const platforms::Board& board);
  ~Disassembler();
  /// Whether make() knows the machine.
  static bool knows(const platforms::Board& board);

  /// The instruction at the beginning of `bytes`, which must not be empty; one of Flow::Unknown if
  /// they are not a valid instruction. Must be called in the order of the code.
  Instruction read(llvm::StringRef bytes, uint64_t address);

  /// Whether `bytes` begin with ARM's undefined instruction, at which a program gives up; the C
  /// library's assembly has it as a word of data.
  [[nodiscard]] bool isTrap(llvm::StringRef bytes) const;

 private:
  struct Machine;
  explicit Disassembler(std::unique_ptr<Machine> machine);
  void count(const Written& written, Instruction& one);
  void choose(const Written& written, Instruction& one);
  void switchByDistance(const Written& written, Instruction& one);
  void judgeStack(const llvm::MCInst& inst, const Written& written, Instruction& one);

  std::unique_ptr<Machine> machine_;
  std::optional<int64_t> count_;  // the value of ecx
  uint64_t counted_at_ = 0;
  std::string compared_;  // "r3" of ARM's "cmp r3, #10" immediately before
  int64_t compared_with_ = 0;
  /// From x86's "movl -8(%ebx,%ecx,4), %ecx", "addl %ebx, %ecx" immediately before: used by the
  /// next jump.
  std::string added_, jumps_by_;
  int64_t table_ = 0;
  uint64_t compared_at_ = 0;
};

}  // namespace glider::codegen
