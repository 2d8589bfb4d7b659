// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/source_manager.h"

#include <llvm/IR/DIBuilder.h>
#include <llvm/IR/IRBuilder.h>
#include <llvm/IR/Module.h>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace glider::codegen {

/// A field of a struct that a debugger shows.
struct DebugMember {
  std::string name;
  uint64_t offset = 0;  ///< bytes from the start of the struct
  llvm::DIType* type = nullptr;
};

/// Line tables: which generated code belongs to which line of the mission; and the names and types
/// of what is in its memory. Without sources describe(), locate() and finish() do nothing.
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
  /// Whether there are sources: what follows, up to finish(), needs them.
  [[nodiscard]] bool active() const { return unit_ != nullptr; }
  [[nodiscard]] uint32_t lineOf(support::SourceRange range) const;
  /// A number of 8 bytes, whose type is named after its unit.
  llvm::DIType* number(const std::string& unit);
  /// Of 4 bytes, unsigned.
  llvm::DIType* word();
  /// A word that is one of `names`.
  llvm::DIType* oneOf(const std::string& name, const std::vector<std::string>& names);
  llvm::DIType* record(const std::string& name, uint64_t bytes,
                       const std::vector<DebugMember>& members);
  /// `count` elements, the first with the number `first`.
  llvm::DIType* list(llvm::DIType* element, int64_t first, uint64_t count);
  /// Names what is `offset` bytes from the start of `memory`.
  void name(llvm::GlobalVariable& memory, uint64_t offset, const std::string& name,
            llvm::DIType* type, support::SourceRange range);
  /// To be called once, when all functions exist.
  void finish();

 private:
  llvm::DIFile* fileOf(uint32_t file);

  const support::SourceManager* sources_;
  llvm::DIBuilder builder_;
  llvm::DICompileUnit* unit_ = nullptr;
  llvm::DISubroutineType* type_ = nullptr;
  std::map<uint32_t, llvm::DIFile*> files_;
  std::map<std::string, llvm::DIType*> numbers_;
};

}  // namespace glider::codegen
