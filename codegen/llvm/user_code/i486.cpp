// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/llvm/user_code/i486.h"

#include "codegen/llvm/user_code/assembly_reader.h"
#include "codegen/llvm/user_code/text_sections.h"
#include "support/diagnostics/ids/target.h"

#include <llvm/Support/TargetSelect.h>

#include <regex>

namespace glider::codegen {
namespace {

using support::Result;

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
  LLVMInitializeX86TargetInfo();
  LLVMInitializeX86TargetMC();
  LLVMInitializeX86Disassembler();
  AssemblyReader reader("i386-unknown-linux", "", "");
  const auto check = [&](const auto& /*section*/, llvm::ArrayRef<uint8_t> code) -> Result<void> {
    while (!code.empty()) {
      if (const std::string instruction = reader.next(code); isNewer(instruction)) {
        const std::string mnemonic = instruction.substr(0, instruction.find_first_of("\t "));
        return support::fail(support::diagnostics::missingInstruction, name, mnemonic, board.name);
      }
    }
    return {};
  };
  return checkTextSections(object, name, check);
}

}  // namespace glider::codegen
