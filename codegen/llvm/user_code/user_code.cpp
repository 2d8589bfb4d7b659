// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/user_code.h"

#include "codegen/llvm/user_code/bitcode.h"
#include "codegen/llvm/user_code/user_file.h"
#include "ir/core/c_symbols.h"
#include "support/diagnostics/ids/target.h"

#include <fmt/format.h>

#include <algorithm>

namespace glider::codegen {
namespace {

using platforms::Board;
using support::Result;

/// Every symbol that the mission needs from C.
std::vector<std::string> symbolsOf(const ir::Mission& mission) {
  const ir::CInterface used = ir::usedInC(mission);
  std::vector<std::string> symbols;
  for (const auto& function : used.functions) {
    symbols.push_back(function.symbol);
  }
  for (const auto& sensor : used.sensors) {
    symbols.push_back(sensor.symbol);
  }
  for (const auto& behaviour : used.behaviours) {
    symbols.push_back(behaviour.symbol);
  }
  return symbols;
}

bool defines(const std::vector<UserFile>& files, const std::string& symbol) {
  return std::ranges::any_of(
      files, [&](const UserFile& file) { return std::ranges::count(file.defines, symbol) > 0; });
}

/// Refuses a file that defines a symbol that the mission needs with other types.
Result<void> checkDeclarations(const std::vector<UserFile>& files, const std::string& wanted) {
  const auto mission = ir::readSymbol(wanted);
  if (!mission || defines(files, wanted)) {
    return {};
  }
  for (const UserFile& file : files) {
    for (const std::string& symbol : file.defines) {
      const auto defined = ir::readSymbol(symbol);
      if (defined && defined->kind == mission->kind && defined->name == mission->name) {
        return support::fail(support::diagnostics::otherDeclaration, file.name,
                             defined->declaration, mission->declaration);
      }
    }
  }
  return {};
}

}  // namespace

Result<UserCode> UserCode::load(const std::vector<std::filesystem::path>& files,
                                const ir::Mission& mission, const Board& board) {
  auto folder = ScratchFolder::make();
  if (!folder) {
    return std::unexpected(folder.error());
  }
  UserCode code(std::move(*folder));
  std::vector<UserFile> read;
  for (const auto& file : files) {
    auto one = readUserFile(file, board, code.folder_);
    if (!one) {
      return std::unexpected(one.error());
    }
    // A copy, so that the linker reads what was checked even if the file changes meanwhile.
    auto copy = code.folder_.write(fmt::format("user{}", read.size()), one->content);
    if (!copy) {
      return std::unexpected(copy.error());
    }
    code.inputs_.push_back(std::move(*copy));
    read.push_back(std::move(*one));
  }
  for (const std::string& symbol : symbolsOf(mission)) {
    if (auto right = checkDeclarations(read, symbol); !right) {
      return std::unexpected(right.error());
    }
  }
  return code;
}

void UserCode::addTo(CodegenOptions& options) const {
  if (inputs_.empty()) {
    return;
  }
  options.further_inputs.insert(options.further_inputs.end(), inputs_.begin(), inputs_.end());
  options.optimisation_level = std::min(options.optimisation_level, kUserCodeLevel);
}

}  // namespace glider::codegen
