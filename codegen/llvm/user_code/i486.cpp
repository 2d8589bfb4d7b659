// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/llvm/user_code/i486.h"

#include "support/check.h"
#include "support/diagnostics/ids/target.h"

#include <llvm/MC/MCAsmInfo.h>
#include <llvm/MC/MCContext.h>
#include <llvm/MC/MCDisassembler/MCDisassembler.h>
#include <llvm/MC/MCInst.h>
#include <llvm/MC/MCInstPrinter.h>
#include <llvm/MC/MCInstrInfo.h>
#include <llvm/MC/MCRegisterInfo.h>
#include <llvm/MC/MCSubtargetInfo.h>
#include <llvm/MC/MCTargetOptions.h>
#include <llvm/MC/TargetRegistry.h>
#include <llvm/Support/TargetSelect.h>
#include <llvm/Support/raw_ostream.h>
#include <llvm/TargetParser/Triple.h>

#include <memory>
#include <regex>

namespace glider::codegen {
namespace {

using support::Result;

/// Turns bytes of i386 code into assembly.
class Disassembler {
 public:
  Disassembler() {
    LLVMInitializeX86TargetInfo();
    LLVMInitializeX86TargetMC();
    LLVMInitializeX86Disassembler();
    const llvm::Triple triple("i386-unknown-linux");
    std::string error;
    const llvm::Target* target = llvm::TargetRegistry::lookupTarget(triple.str(), error);
    CHECK(target != nullptr, error.c_str());
    registers_.reset(target->createMCRegInfo(triple.str()));
    syntax_.reset(target->createMCAsmInfo(*registers_, triple.str(), options_));
    machine_.reset(target->createMCSubtargetInfo(triple.str(), "", ""));
    instructions_.reset(target->createMCInstrInfo());
    context_ =
        std::make_unique<llvm::MCContext>(triple, syntax_.get(), registers_.get(), machine_.get());
    reader_.reset(target->createMCDisassembler(*machine_, *context_));
    printer_.reset(target->createMCInstPrinter(triple, 0, *syntax_, *instructions_, *registers_));
  }

  /// Takes an instruction from the front of `code`; empty for invalid bytes.
  std::string next(llvm::ArrayRef<uint8_t>& code) {
    llvm::MCInst instruction;
    uint64_t size = 0;
    const auto status = reader_->getInstruction(instruction, size, code, 0, llvm::nulls());
    code = code.drop_front(size == 0 ? 1 : std::min<uint64_t>(size, code.size()));
    if (status != llvm::MCDisassembler::Success) {
      return "";
    }
    std::string text;
    llvm::raw_string_ostream stream(text);
    printer_->printInst(&instruction, 0, "", *machine_, stream);
    return llvm::StringRef(stream.str()).trim().str();
  }

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

/// As in scripts/check_i486.
bool isNewer(const std::string& instruction) {
  static const std::regex names(
      "^(f?cmov|fu?comp?i\\b|fisttp|endbr|cmpxchg8b|rdtsc|rdpmc|rdmsr|nop[lw]\\b|sysenter|syscall|"
      "prefetch|emms|[lm]fence|sfence|v?(ld|st)mxcsr|fx(save|rstor)|popcnt|[lt]zcnt|rdrand|"
      "ud2|pause)|%[xyz]?mm[0-9]");
  return std::regex_search(instruction, names);
}

}  // namespace

Result<void> checkI486(const llvm::object::ELFObjectFileBase& object, const std::string& name,
                       const platforms::Board& board) {
  Disassembler disassembler;
  for (const llvm::object::SectionRef& section : object.sections()) {
    if (!section.isText()) {
      continue;
    }
    auto content = section.getContents();
    if (!content) {
      return support::fail(support::diagnostics::notLinkable, name,
                           llvm::toString(content.takeError()));
    }
    llvm::ArrayRef<uint8_t> code(content->bytes_begin(), content->bytes_end());
    while (!code.empty()) {
      if (const std::string instruction = disassembler.next(code); isNewer(instruction)) {
        const std::string mnemonic = instruction.substr(0, instruction.find_first_of("\t "));
        return support::fail(support::diagnostics::missingInstruction, name, mnemonic, board.name);
      }
    }
  }
  return {};
}

}  // namespace glider::codegen
