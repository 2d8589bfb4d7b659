// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <llvm/ADT/ArrayRef.h>
#include <llvm/MC/MCTargetOptions.h>

#include <cstdint>
#include <memory>
#include <string>

namespace llvm {
class MCAsmInfo;
class MCContext;
class MCDisassembler;
class MCInstPrinter;
class MCInstrInfo;
class MCRegisterInfo;
class MCSubtargetInfo;
}  // namespace llvm

namespace glider::codegen {

/// Turns machine code into assembly. LLVM's disassembler for the machine must be initialised.
class AssemblyReader {
 public:
  AssemblyReader(const std::string& triple, const std::string& cpu, const std::string& features);
  ~AssemblyReader();

  /// Takes an instruction from the front of `code`; empty for one that the processor does not have.
  std::string next(llvm::ArrayRef<uint8_t>& code);

 private:
  llvm::MCTargetOptions options_;
  std::unique_ptr<llvm::MCRegisterInfo> registers_;
  std::unique_ptr<llvm::MCAsmInfo> syntax_;
  std::unique_ptr<llvm::MCSubtargetInfo> machine_;
  std::unique_ptr<llvm::MCInstrInfo> instructions_;
  std::unique_ptr<llvm::MCContext> context_;
  std::unique_ptr<llvm::MCDisassembler> reader_;
  std::unique_ptr<llvm::MCInstPrinter> printer_;
};

}  // namespace glider::codegen
