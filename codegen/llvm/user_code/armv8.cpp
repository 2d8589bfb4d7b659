// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/llvm/user_code/armv8.h"

#include "codegen/llvm/user_code/assembly_reader.h"
#include "codegen/llvm/user_code/text_sections.h"
#include "support/diagnostics/ids/target.h"

#include <fmt/format.h>
#include <llvm/Support/Endian.h>
#include <llvm/Support/TargetSelect.h>

#include <algorithm>
#include <array>
#include <map>
#include <string_view>

namespace glider::codegen {
namespace {

using support::Result;

constexpr uint64_t kInstruction = 4;

/// By offset in a section, whether what follows is data: from the symbols `$x` and `$d`.
std::map<uint64_t, bool> dataIn(const llvm::object::ELFObjectFileBase& object,
                                const llvm::object::SectionRef& section) {
  std::map<uint64_t, bool> data;
  for (const llvm::object::ELFSymbolRef symbol : object.symbols()) {
    const auto name = llvm::expectedToOptional(symbol.getName());
    const auto place = llvm::expectedToOptional(symbol.getSection());
    const auto offset = llvm::expectedToOptional(symbol.getValue());
    const bool marks = name && (name->starts_with("$x") || name->starts_with("$d"));
    if (marks && offset && place && *place == section) {
      data[*offset] = name->starts_with("$d");
    }
  }
  return data;
}

bool isFused(std::string_view mnemonic) {
  static constexpr std::array<std::string_view, 6> kFused = {"fmadd",  "fmsub", "fnmadd",
                                                             "fnmsub", "fmla",  "fmls"};
  return std::ranges::find(kFused, mnemonic) != kFused.end();
}

Result<void> checkCode(llvm::ArrayRef<uint8_t> code, const std::map<uint64_t, bool>& data,
                       const std::string& name, const platforms::Board& board) {
  AssemblyReader reader(board.triple, board.cpu, board.features);
  const size_t size = code.size();
  while (code.size() >= kInstruction) {
    const auto after = data.upper_bound(size - code.size());
    if (after != data.begin() && std::prev(after)->second) {
      code = code.drop_front(kInstruction);
      continue;
    }
    const uint32_t word = llvm::support::endian::read32le(code.data());
    const std::string instruction = reader.next(code);
    const std::string mnemonic = instruction.substr(0, instruction.find_first_of("\t "));
    if (instruction.empty()) {
      return support::fail(support::diagnostics::missingInstruction, name,
                           fmt::format("{:#010x}", word), board.name);
    }
    if (isFused(mnemonic)) {
      return support::fail(support::diagnostics::fusedMultiplication, name, mnemonic, board.name);
    }
  }
  return {};
}

}  // namespace

Result<void> checkArmv8(const llvm::object::ELFObjectFileBase& object, const std::string& name,
                        const platforms::Board& board) {
  LLVMInitializeAArch64TargetInfo();
  LLVMInitializeAArch64TargetMC();
  LLVMInitializeAArch64Disassembler();
  return checkTextSections(
      object, name, [&](const llvm::object::SectionRef& section, llvm::ArrayRef<uint8_t> code) {
        return checkCode(code, dataIn(object, section), name, board);
      });
}

}  // namespace glider::codegen
