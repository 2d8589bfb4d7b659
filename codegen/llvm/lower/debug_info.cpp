// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/llvm/lower/debug_info.h"

#include <llvm/BinaryFormat/Dwarf.h>

#include <filesystem>

namespace glider::codegen {

DebugInfo::DebugInfo(llvm::Module& module, const support::SourceManager* sources,
                     support::SourceRange main)
    : sources_(sources), builder_(module) {
  if (sources == nullptr || !main.valid()) {
    return;
  }
  constexpr unsigned kDwarfVersion = 4;  // that the debuggers of the boards' time can read
  module.addModuleFlag(llvm::Module::Warning, "Debug Info Version", llvm::DEBUG_METADATA_VERSION);
  // The runtime that is linked in has a flag of its own, which may be a later version.
  module.addModuleFlag(llvm::Module::Override, "Dwarf Version", kDwarfVersion);
  unit_ = builder_.createCompileUnit(llvm::dwarf::DW_LANG_C, fileOf(main.file), "glidercc", true,
                                     "", 0, "", llvm::DICompileUnit::LineTablesOnly);
  type_ = builder_.createSubroutineType(builder_.getOrCreateTypeArray({}));
}

llvm::DIFile* DebugInfo::fileOf(uint32_t file) {
  llvm::DIFile*& found = files_[file];
  if (found == nullptr) {
    // As the pilot named it, so that the same mission gives the same bytes in every folder.
    const std::filesystem::path path = sources_->name(file);
    found = builder_.createFile(path.filename().string(), path.parent_path().string());
  }
  return found;
}

void DebugInfo::describe(llvm::Function& function, const std::string& name,
                         support::SourceRange range) {
  if (!active() || !range.valid()) {
    return;
  }
  const uint32_t line = sources_->place(range.file, range.begin).line;
  llvm::DIFile* file = fileOf(range.file);
  function.setSubprogram(builder_.createFunction(
      file, name, "", file, line, type_, line, llvm::DINode::FlagZero,
      llvm::DISubprogram::SPFlagDefinition | llvm::DISubprogram::SPFlagLocalToUnit));
}

void DebugInfo::locate(llvm::IRBuilder<>& builder, support::SourceRange range) {
  llvm::DISubprogram* scope = builder.GetInsertBlock()->getParent()->getSubprogram();
  // A line of a file other than the function's would need a scope of its own: the line of the use
  // is given instead.
  if (scope == nullptr || !range.valid() || fileOf(range.file) != scope->getFile()) {
    return;
  }
  const support::LineColumn at = sources_->place(range.file, range.begin);
  builder.SetCurrentDebugLocation(
      llvm::DILocation::get(builder.getContext(), at.line, at.column, scope));
}

void DebugInfo::finish() {
  if (active()) {
    builder_.finalize();
  }
}

}  // namespace glider::codegen
