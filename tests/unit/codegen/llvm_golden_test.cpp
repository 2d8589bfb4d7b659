// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// tests/golden/llvm: each file is a mission in the IR's text form, and FileCheck lines for the LLVM
// that it becomes. Its line "# RUN: BOARD OLEVEL" says for which board and at which level.

#include "codegen/llvm/llvm.h"
#include "support/files.h"
#include "tests/support/command.h"
#include "tests/unit/codegen/compiled_mission.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <regex>

namespace glider::codegen_tests {
namespace {

namespace fs = std::filesystem;

class LlvmGolden : public testing::TestWithParam<fs::path> {};

TEST_P(LlvmGolden, HoldsTheLinesThatMatter) {
  const std::string text = support::readFile(GetParam()).value_or("");
  std::smatch run;
  ASSERT_TRUE(std::regex_search(text, run, std::regex("# RUN: (\\w+) O([0-3])\n")));
  const Checked checked = checkedMission(text);
  codegen::CodegenOptions options;
  options.optimisation_level = std::stoi(run[2]);
  const auto llvm = codegen::emitLlvm(checked.input(), board(run[1]), options);
  ASSERT_TRUE(llvm.has_value()) << llvm.error().message;
  const tests::TemporaryFolder folder;
  const fs::path input = folder.write("mission.ll", *llvm);
  const tests::Outcome outcome = tests::runShell(
      fmt::format("{} --input-file {} {}", GLIDER_FILECHECK, input.string(), GetParam().string()));
  EXPECT_EQ(outcome.status, 0) << outcome.err;
}

std::vector<fs::path> goldens() {
  std::vector<fs::path> found;
  for (const auto& entry : fs::directory_iterator(GLIDER_SOURCE_DIR "/tests/golden/llvm")) {
    found.push_back(entry.path());
  }
  return found;
}

INSTANTIATE_TEST_SUITE_P(Files, LlvmGolden, testing::ValuesIn(goldens()),
                         [](const auto& param) { return param.param.stem().string(); });

}  // namespace
}  // namespace glider::codegen_tests
