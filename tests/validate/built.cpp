// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/validate/built.h"

#include "codegen/llvm/lower/lower_mission.h"
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

}  // namespace

codegen::Validation validate(const codegen::Input& input, const std::string& board_name, int level,
                             const Change& lowered, const Change& optimised) {
  const platforms::Board board =
      sure(platforms::loadBoard(std::filesystem::path(GLIDER_BINARY_DIR) / "share/glidercc/boards" /
                                board_name / "board.toml"));
  llvm::LLVMContext context;
  const auto machine = sure(codegen::makeMachine(board, level, codegen::ProgramKind::Executable));
  const codegen::MissionPart whole = codegen::wholeOf(input.mission);
  const auto module = codegen::lowerMission(input, whole, *machine, nullptr, context);
  if (lowered) {
    lowered(*module);
  }
  if (level > 1) {
    sure(codegen::importRuntime(*module, board.folder / "inline.bc"));
  }
  codegen::optimise(*module, *machine, level);
  if (optimised) {
    optimised(*module);
  }
  return sure(codegen::validatePart(input, whole, *module, board.folder / "inline.bc"));
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
