// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "codegen/llvm/budget/flow_of.h"
#include "codegen/llvm/budget/image.h"

#include <llvm/ADT/StringRef.h>
#include <llvm/TargetParser/Triple.h>

#include <cstdint>
#include <memory>

namespace llvm {
class MCInst;
class MCInstrDesc;
}  // namespace llvm

namespace glider::codegen {

/// An instruction as LLVM decodes it.
struct Decoded {
  const llvm::MCInst& inst;
  const llvm::MCInstrDesc& about;
  Written written;
};

/// What differs between the processors whose machine code can be followed. It remembers what the
/// last instructions said, so it must be asked in the order of the code.
class Architecture {
 public:
  virtual ~Architecture() = default;
  /// Null for a machine that is not known.
  static std::unique_ptr<Architecture> of(const llvm::Triple& triple);

  [[nodiscard]] virtual const StackMachine& stackMachine() const = 0;
  /// Registers LLVM's disassembler.
  virtual void initialiseDisassembler() const = 0;
  /// The number of the register that LLVM calls `name`, by StackEffect; kNone for any other.
  [[nodiscard]] virtual uint8_t numberOf(llvm::StringRef name) const = 0;
  /// Without its target.
  [[nodiscard]] virtual Flow flow(const Written& written) const = 0;
  /// Without `writes`; `known` only where the pointer may move in ways that `to` does not say.
  [[nodiscard]] virtual StackEffect stack(const Written& written) const = 0;
  /// Completes an instruction by what it mentions, and by those before it.
  virtual void complete(const Decoded& decoded, Instruction& one) = 0;
  /// Makes an instruction of `bytes` (at least one) that LLVM does not decode.
  virtual void undecoded(llvm::StringRef bytes, Instruction& one) = 0;
  /// Whether `bytes` begin with an undefined instruction, at which a program gives up, even where
  /// the C library's assembly has it as a word of data.
  [[nodiscard]] virtual bool isTrap(llvm::StringRef /*bytes*/) const { return false; }
};

std::unique_ptr<Architecture> makeArm();
std::unique_ptr<Architecture> makeThumb();
std::unique_ptr<Architecture> makeX86();
std::unique_ptr<Architecture> makeAArch64();

}  // namespace glider::codegen
