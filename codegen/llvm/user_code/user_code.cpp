// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/user_code.h"

#include "codegen/llvm/program/emit.h"
#include "codegen/llvm/target/machine.h"
#include "codegen/llvm/user_code/bitcode.h"
#include "codegen/llvm/user_code/user_file.h"
#include "ir/core/c_symbols.h"
#include "support/diagnostics/catalogue.h"

#include <fmt/format.h>
#include <llvm/IR/IRBuilder.h>
#include <llvm/IR/LLVMContext.h>

#include <algorithm>

namespace glider::codegen {
namespace {

using platforms::Board;
using support::DiagnosticId;
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
        return support::fail(DiagnosticId::otherDeclaration, file.name, defined->declaration,
                             mission->declaration);
      }
    }
  }
  return {};
}

/// Defines `symbol` as a function with any arguments that returns unknown.
void defineUnknown(llvm::Module& module, const std::string& symbol) {
  llvm::Type* number = llvm::Type::getDoubleTy(module.getContext());
  auto* function = llvm::Function::Create(llvm::FunctionType::get(number, false),
                                          llvm::GlobalValue::ExternalLinkage, symbol, module);
  llvm::IRBuilder<> builder(llvm::BasicBlock::Create(module.getContext(), "", function));
  builder.CreateRet(llvm::ConstantFP::getNaN(number));
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

Result<UserCode> UserCode::standIn(const ir::Mission& mission, const Board& board) {
  auto folder = ScratchFolder::make();
  auto machine = makeMachine(board, kUserCodeLevel, ProgramKind::SharedObject);
  if (!folder || !machine) {
    return std::unexpected(folder ? machine.error() : folder.error());
  }
  llvm::LLVMContext context;
  llvm::Module module("stand-in", context);
  module.setTargetTriple((*machine)->getTargetTriple().str());
  module.setDataLayout((*machine)->createDataLayout());
  for (const std::string& symbol : symbolsOf(mission)) {
    defineUnknown(module, symbol);
    module.getFunction(symbol)->setLinkage(llvm::GlobalValue::WeakAnyLinkage);
  }
  UserCode code(std::move(*folder));
  auto file = code.folder_.write("stand-in.o",
                                 emitCode(module, **machine, llvm::CodeGenFileType::ObjectFile));
  if (!file) {
    return std::unexpected(file.error());
  }
  code.inputs_.push_back(std::move(*file));
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
