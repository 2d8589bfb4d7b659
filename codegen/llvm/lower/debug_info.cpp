// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/llvm/lower/debug_info.h"

#include <llvm/BinaryFormat/Dwarf.h>

#include <filesystem>

namespace glider::codegen {
namespace {

constexpr unsigned kByteBits = 8, kWordBits = 32, kNumberBits = 64;

}  // namespace

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
                                     "", 0, "", llvm::DICompileUnit::FullDebug);
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
  const uint32_t line = lineOf(range);
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

uint32_t DebugInfo::lineOf(support::SourceRange range) const {
  return sources_ != nullptr && range.valid() ? sources_->place(range.file, range.begin).line : 0;
}

llvm::DIType* DebugInfo::number(const std::string& unit) {
  llvm::DIType*& found = numbers_[unit];
  if (found == nullptr) {
    found = builder_.createBasicType(unit, kNumberBits, llvm::dwarf::DW_ATE_float);
  }
  return found;
}

llvm::DIType* DebugInfo::word() {
  return builder_.createBasicType("word", kWordBits, llvm::dwarf::DW_ATE_unsigned);
}

llvm::DIType* DebugInfo::oneOf(const std::string& name, const std::vector<std::string>& names) {
  std::vector<llvm::Metadata*> values;
  for (uint64_t i = 0; i < names.size(); ++i) {
    values.push_back(builder_.createEnumerator(names[i], i, /*IsUnsigned=*/true));
  }
  return builder_.createEnumerationType(unit_, name, unit_->getFile(), 0, kWordBits, kWordBits,
                                        builder_.getOrCreateArray(values), word());
}

llvm::DIType* DebugInfo::record(const std::string& name, uint64_t bytes,
                                const std::vector<DebugMember>& members) {
  std::vector<llvm::Metadata*> fields;
  for (const DebugMember& member : members) {
    fields.push_back(builder_.createMemberType(
        unit_, member.name, unit_->getFile(), 0, member.type->getSizeInBits(), 0,
        member.offset * kByteBits, llvm::DINode::FlagZero, member.type));
  }
  return builder_.createStructType(unit_, name, unit_->getFile(), 0, bytes * kByteBits, 0,
                                   llvm::DINode::FlagZero, nullptr,
                                   builder_.getOrCreateArray(fields));
}

llvm::DIType* DebugInfo::list(llvm::DIType* element, int64_t first, uint64_t count) {
  llvm::Metadata* range = builder_.getOrCreateSubrange(first, static_cast<int64_t>(count));
  return builder_.createArrayType(count * element->getSizeInBits(), 0, element,
                                  builder_.getOrCreateArray({range}));
}

void DebugInfo::name(llvm::GlobalVariable& memory, uint64_t offset, const std::string& name,
                     llvm::DIType* type, support::SourceRange range) {
  llvm::DIFile* file = range.valid() ? fileOf(range.file) : unit_->getFile();
  llvm::DIExpression* at = builder_.createExpression({llvm::dwarf::DW_OP_plus_uconst, offset});
  memory.addDebugInfo(builder_.createGlobalVariableExpression(
      unit_, name, "", file, lineOf(range), type, /*IsLocalToUnit=*/false, /*isDefined=*/true, at));
}

void DebugInfo::finish() {
  if (active()) {
    builder_.finalize();
  }
}

}  // namespace glider::codegen
