// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/source_manager.h"

#include <llvm/IR/DIBuilder.h>
#include <llvm/IR/IRBuilder.h>
#include <llvm/IR/Module.h>

#include <map>
#include <string>

namespace glider::codegen {

/// Line tables: which generated code belongs to which line of the mission. Does nothing without
/// sources.
class DebugInfo {
 public:
  /// `sources` may be null, otherwise it holds the files of the ranges given below; `main` is a
  /// place in the mission's main file, or an empty range, which also means no line tables.
  DebugInfo(llvm::Module& module, const support::SourceManager* sources, support::SourceRange main);

  /// Gives `function` line tables under `name`, which a debugger shows, starting at `range`.
  void describe(llvm::Function& function, const std::string& name, support::SourceRange range);
  /// The code that `builder` generates from now on belongs to `range`; for an empty range the place
  /// before stays valid. The builder must be inside a function.
  void locate(llvm::IRBuilder<>& builder, support::SourceRange range);
  /// To be called once, when all functions exist.
  void finish();

 private:
  [[nodiscard]] bool active() const { return unit_ != nullptr; }
  llvm::DIFile* fileOf(uint32_t file);

  const support::SourceManager* sources_;
  llvm::DIBuilder builder_;
  llvm::DICompileUnit* unit_ = nullptr;
  llvm::DISubroutineType* type_ = nullptr;
  std::map<uint32_t, llvm::DIFile*> files_;
};

}  // namespace glider::codegen
