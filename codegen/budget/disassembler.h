// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "codegen/budget/flow_of.h"
#include "codegen/budget/image.h"

#include <llvm/ADT/StringRef.h>

#include <cstdint>
#include <memory>
#include <optional>

namespace glider::codegen {

/// Machine code of one board, instruction by instruction.
class Disassembler {
 public:
  /// GL4002 for a machine that it does not know: 32-bit x86 and ARM are known.
  static support::Result<std::unique_ptr<Disassembler>> make(const platforms::Board& board);
  ~Disassembler();
  /// Whether make() knows the machine.
  static bool knows(const platforms::Board& board);

  /// The instruction with which `bytes`, not empty, begin; one of Flow::Unknown if they are none.
  /// Called in the order of the code.
  Instruction read(llvm::StringRef bytes, uint64_t address);

 private:
  struct Machine;
  explicit Disassembler(std::unique_ptr<Machine> machine);
  void count(const Written& written, Instruction& one);

  std::unique_ptr<Machine> machine_;
  std::optional<int64_t> count_;  // what ecx holds
  uint64_t counted_at_ = 0;
};

}  // namespace glider::codegen
