// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/validate/built.h"

#include "codegen/llvm/lower/lower_mission.h"
#include "codegen/llvm/program/emit.h"
#include "codegen/llvm/program/optimise.h"
#include "codegen/llvm/program/program.h"
#include "codegen/llvm/target/machine.h"
#include "codegen/llvm/validate/validate.h"
#include "platforms/load/board.h"
#include "support/check.h"

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>

namespace glider::validate_test {
namespace {

template <typename T>
T sure(support::Result<T> result) {
  CHECK(result.has_value(), result.error().message.c_str());
  if constexpr (!std::is_void_v<T>) {
    return std::move(*result);
  }
}

/// A mission's code, and what it needs.
struct Built {
  platforms::Board board;
  std::unique_ptr<llvm::LLVMContext> context = std::make_unique<llvm::LLVMContext>();
  std::unique_ptr<llvm::Module> module;
};

Built build(const codegen::Input& input, const std::string& board_name, int level,
            const Change& lowered) {
  Built built{
      .board = sure(platforms::loadBoard(std::filesystem::path(GLIDER_BINARY_DIR) /
                                         "share/glidercc/boards" / board_name / "board.toml")),
      .module = nullptr};
  const auto machine =
      sure(codegen::makeMachine(built.board, level, codegen::ProgramKind::Executable));
  built.module = codegen::lowerMission(input, codegen::wholeOf(input.mission), *machine, nullptr,
                                       *built.context);
  if (lowered) {
    lowered(*built.module);
  }
  if (level > 1) {
    sure(codegen::importRuntime(*built.module, built.board.folder / "inline.bc"));
  }
  codegen::optimise(*built.module, *machine, level);
  return built;
}

}  // namespace

codegen::Validation validate(const codegen::Input& input, const std::string& board, int level,
                             const Change& lowered, const Change& optimised) {
  const Built built = build(input, board, level, lowered);
  if (optimised) {
    optimised(*built.module);
  }
  return sure(codegen::validatePart(input, codegen::wholeOf(input.mission), *built.module,
                                    built.board.folder / "inline.bc"));
}

std::string codeOf(const codegen::Input& input, const std::string& board, int level,
                   const Change& lowered) {
  return codegen::printModule(*build(input, board, level, lowered).module);
}

uint64_t setting(const char* name, uint64_t otherwise) {
  const char* text = std::getenv(name);
  return text != nullptr ? std::strtoull(text, nullptr, 10) : otherwise;
}

std::string whatIsNotSame(const codegen::Validation& validation) {
  std::string words;
  for (const codegen::Validated& one : validation) {
    if (one.verdict != codegen::Verdict::Same) {
      words += fmt::format("{} {}: {}\n", one.what,
                           one.verdict == codegen::Verdict::Differs ? "differs" : "is undecided",
                           one.words);
    }
  }
  return words;
}

}  // namespace glider::validate_test
