// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/llvm/target/machine.h"

#include "support/diagnostics/ids/target.h"

#include <llvm/MC/MCSubtargetInfo.h>
#include <llvm/MC/TargetRegistry.h>
#include <llvm/Support/TargetSelect.h>
#include <llvm/TargetParser/Triple.h>

#include <mutex>
#include <optional>
#include <string>

namespace glider::codegen {
namespace {

using platforms::Board;

// The assembly parsers are for inline assembly in the runtime.
void initialiseX86() {
  LLVMInitializeX86TargetInfo();
  LLVMInitializeX86Target();
  LLVMInitializeX86TargetMC();
  LLVMInitializeX86AsmPrinter();
  LLVMInitializeX86AsmParser();
}

void initialiseArm() {
  LLVMInitializeARMTargetInfo();
  LLVMInitializeARMTarget();
  LLVMInitializeARMTargetMC();
  LLVMInitializeARMAsmPrinter();
  LLVMInitializeARMAsmParser();
}

void initialiseAArch64() {
  LLVMInitializeAArch64TargetInfo();
  LLVMInitializeAArch64Target();
  LLVMInitializeAArch64TargetMC();
  LLVMInitializeAArch64AsmPrinter();
  LLVMInitializeAArch64AsmParser();
}

/// Initialises only the target that is needed: each costs start-up time. Once, because LLVM's
/// registry does not support several threads.
void initialise(const llvm::Triple& triple) {
  static std::once_flag x86;
  static std::once_flag arm;
  static std::once_flag aarch64;
  if (triple.isX86()) {
    std::call_once(x86, initialiseX86);
  } else if (triple.isARM()) {
    std::call_once(arm, initialiseArm);
  } else if (triple.isAArch64()) {
    std::call_once(aarch64, initialiseAArch64);
  }
}

llvm::TargetOptions targetOptions(const Board& board) {
  llvm::TargetOptions options;
  options.AllowFPOpFusion = llvm::FPOpFusion::Strict;
  options.FloatABIType =
      board.float_abi == platforms::FloatAbi::Soft ? llvm::FloatABI::Soft : llvm::FloatABI::Hard;
  options.FunctionSections = true;  // for --gc-sections
  options.DataSections = true;
  return options;
}

llvm::CodeGenOptLevel codegenLevel(int level) {
  switch (level) {
    case 0:
      return llvm::CodeGenOptLevel::None;
    case 1:
      return llvm::CodeGenOptLevel::Less;
    case 2:
      return llvm::CodeGenOptLevel::Default;
    default:
      return llvm::CodeGenOptLevel::Aggressive;
  }
}

/// Checked in advance, because LLVM prints a message to the terminal for an unknown cpu.
bool hasCpu(const llvm::Target& target, const llvm::Triple& triple, const std::string& cpu) {
  const std::unique_ptr<llvm::MCSubtargetInfo> info(
      target.createMCSubtargetInfo(triple.str(), "", ""));
  return info && info->isCPUStringValid(cpu);
}

}  // namespace

support::Result<std::unique_ptr<llvm::TargetMachine>> makeMachine(const Board& board, int level,
                                                                  ProgramKind kind) {
  const llvm::Triple triple(llvm::Triple::normalize(board.triple));
  initialise(triple);
  std::string ignored;
  const bool linked = triple.isX86() || triple.isARM() || triple.isAArch64();
  const llvm::Target* target =
      linked ? llvm::TargetRegistry::lookupTarget(triple.str(), ignored) : nullptr;
  const bool pic = kind == ProgramKind::SharedObject ||
                   board.relocation == platforms::Relocation::PositionIndependent;
  std::unique_ptr<llvm::TargetMachine> machine;
  if (target != nullptr && hasCpu(*target, triple, board.cpu)) {
    machine.reset(target->createTargetMachine(
        triple.str(), board.cpu, board.features, targetOptions(board),
        pic ? llvm::Reloc::PIC_ : llvm::Reloc::Static, std::nullopt, codegenLevel(level)));
    // Code that several functions share would not say which of them calls something.
    machine->setMachineOutliner(false);
  }
  if (!machine) {
    return support::fail(support::diagnostics::unsupportedMachine, board.name, board.triple,
                         board.cpu);
  }
  return machine;
}

}  // namespace glider::codegen
