// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The line tables of a mission: each guard stands for its line.

#include "support/files.h"
#include "tests/unit/codegen/compiled_mission.h"

#include <gtest/gtest.h>
#include <llvm/DebugInfo/DWARF/DWARFContext.h>
#include <llvm/Object/ELFObjectFile.h>
#include <llvm/Support/MemoryBuffer.h>

#include <filesystem>
#include <functional>
#include <gmock/gmock.h>
#include <set>
#include <string>

namespace glider::codegen_tests {
namespace {

/// The lines of `source` that code of the ELF file `bytes` stands for.
std::set<unsigned> linesOf(const std::string& bytes, const std::string& source) {
  auto object = llvm::object::createBinary(llvm::MemoryBufferRef(bytes, "debug"));
  EXPECT_TRUE(static_cast<bool>(object));
  auto context = llvm::DWARFContext::create(*llvm::cast<llvm::object::ObjectFile>(object->get()));
  std::set<unsigned> lines;
  for (const auto& unit : context->compile_units()) {
    const auto* table = context->getLineTableForUnit(unit.get());
    for (const auto& row : table->Rows) {
      std::string name;
      table->getFileNameByIndex(row.File, "", llvm::DILineInfoSpecifier::FileLineInfoKind::RawValue,
                                name);
      if (name == source && !row.EndSequence) {
        lines.insert(row.Line);
      }
    }
  }
  return lines;
}

/// The version of DWARF in which the ELF file `bytes` describes what comes from `source`.
unsigned versionOf(const std::string& bytes, const std::string& source) {
  auto object = llvm::object::createBinary(llvm::MemoryBufferRef(bytes, "debug"));
  EXPECT_TRUE(static_cast<bool>(object));
  auto context = llvm::DWARFContext::create(*llvm::cast<llvm::object::ObjectFile>(object->get()));
  unsigned version = 0;
  for (const auto& unit : context->compile_units()) {
    const char* name = unit->getUnitDIE().getShortName();
    version = name == source ? unit->getVersion() : version;
  }
  return version;
}

unsigned lineOf(const Checked& checked, const support::SourceRange& range) {
  return checked.sources.place(range.file, range.begin).line;
}

/// Links `checked` for each board at each level and hands what lies at its path to `look`.
void onEachBoard(const Checked& checked,
                 const std::function<void(const std::filesystem::path&, int level)>& look) {
  for (const char* name : kBoards) {
    for (const int level : {0, 2, 3}) {
      SCOPED_TRACE(std::string(name) + std::to_string(level));
      codegen::CodegenOptions options;
      options.optimisation_level = level;
      options.sources = &checked.sources;
      const auto output = testFolder() / "figure2";
      ASSERT_TRUE(codegen::linkExecutable(checked.input(), board(name), options, output));
      look(output, level);
    }
  }
}

TEST(LineTables, HoldGuardsAndActivitiesOfEveryBoard) {
  const Checked checked = figure2();
  onEachBoard(checked, [&](const std::filesystem::path& output, int level) {
    const std::set<unsigned> lines =
        linesOf(support::readFile(output.string() + ".debug").value(), "figure2.ir");
    for (const ir::State& state : checked.mission.states) {
      EXPECT_THAT(lines, testing::Contains(lineOf(checked, state.profile.range)));
      // Above -O0 the guards of a state may become one, which stands for its first line.
      for (size_t i = 0; i < (level == 0 ? state.cases.size() : 1); ++i) {
        EXPECT_THAT(lines, testing::Contains(lineOf(checked, state.cases[i].range)));
      }
    }
    EXPECT_THAT(linesOf(support::readFile(output).value(), "figure2.ir"), testing::IsEmpty());
  });
}

/// The debuggers of the boards' time do not read later versions, so the version does not depend on
/// how the runtime was compiled.
TEST(LineTables, OfTheMissionAreInTheFourthVersionOfDwarf) {
  const Checked checked = figure2();
  onEachBoard(checked, [&](const std::filesystem::path& output, int) {
    EXPECT_EQ(versionOf(support::readFile(output.string() + ".debug").value(), "figure2.ir"), 4U);
  });
}

TEST(LineTables, AreLeftOutIfNotRequested) {
  const Checked checked = figure2();
  codegen::CodegenOptions options;
  options.sources = &checked.sources;
  options.debug = false;
  const auto folder = testFolder();
  ASSERT_TRUE(
      codegen::linkExecutable(checked.input(), board("ts7800"), options, folder / "figure2"));
  EXPECT_FALSE(std::filesystem::exists(folder / "figure2.debug"));
}

}  // namespace
}  // namespace glider::codegen_tests
