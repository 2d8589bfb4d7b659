// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// One test a golden: tests/golden/<stage>/{ok,warn,fail}_*. With GLIDER_UPDATE_GOLDENS set, what is
// expected is rewritten first (scripts/update_goldens) and then compared anyway: a file that does
// not keep what is written to it fails.

#include "tests/golden/golden_file.h"
#include "tests/golden/stages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <regex>
#include <string>
#include <z3.h>

namespace glider::golden {
namespace {

/// Which values a counterexample has is the solver's choice: Debian 13's finds others than Debian
/// 12's, with which the goldens are written.
bool isSolverOfGoldens() {
  unsigned major = 0, minor = 0, build = 0, revision = 0;
  Z3_get_version(&major, &minor, &build, &revision);
  return major == 4 && minor == 8;
}

std::string withoutNumbers(const std::string& text) {
  static const std::regex kNumber("-?[0-9]+(\\.[0-9]+)?");
  return std::regex_replace(text, kNumber, "#");
}

class Golden : public testing::TestWithParam<std::filesystem::path> {};

TEST_P(Golden, SaysWhatIsExpected) {
  const std::filesystem::path path = GetParam();
  const std::string stage = path.parent_path().filename();
  const std::string name = path.filename();
  const GoldenFile golden(path);
  std::filesystem::current_path(path.parent_path());  // imports are looked for beside it
  const Outcome outcome = run(stage, name, golden.input());
  EXPECT_EQ(outcome.refused, name.starts_with("fail_")) << outcome.text;
  EXPECT_EQ(outcome.warned && !outcome.refused, name.starts_with("warn_")) << outcome.text;
  if (std::getenv("GLIDER_UPDATE_GOLDENS") != nullptr) {
    golden.update(outcome.text);
  }
  const GoldenFile kept(path);
  EXPECT_EQ(kept.input(), golden.input());
  if (isSolverOfGoldens() || stage != "prove") {
    EXPECT_EQ(outcome.text, kept.expected()) << "scripts/update_goldens writes what is said now";
  } else {
    EXPECT_EQ(withoutNumbers(outcome.text), withoutNumbers(kept.expected()));
  }
}

constexpr const char* kStages[] = {"parse", "sema", "verify", "prove"};

std::filesystem::path folderOf(const char* stage) {
  return std::filesystem::path(GLIDER_SOURCE_DIR) / "tests" / "golden" / stage;
}

/// A folder that was moved or emptied must not pass as a test.
TEST(Goldens, EveryStageHasSomeOfEachKind) {
  for (const char* stage : kStages) {
    const auto found = goldensIn(folderOf(stage));
    for (const char* kind : {"ok_", "fail_"}) {
      EXPECT_TRUE(std::ranges::any_of(
          found, [&](const auto& path) { return path.filename().string().starts_with(kind); }))
          << stage << " has no golden " << kind << "*.mission";
    }
  }
}

std::string testName(const testing::TestParamInfo<std::filesystem::path>& info) {
  std::string name =
      info.param.parent_path().filename().string() + "_" + info.param.stem().string();
  for (char& c : name) {
    c = std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  }
  return name;
}

auto of(const char* stage) {
  return testing::ValuesIn(goldensIn(folderOf(stage)));
}

// A suite a stage: only the last asks a solver.
INSTANTIATE_TEST_SUITE_P(Parse, Golden, of("parse"), testName);
INSTANTIATE_TEST_SUITE_P(Sema, Golden, of("sema"), testName);
INSTANTIATE_TEST_SUITE_P(Verify, Golden, of("verify"), testName);
INSTANTIATE_TEST_SUITE_P(Prove, Golden, of("prove"), testName);
INSTANTIATE_TEST_SUITE_P(Errors, Golden, of("errors"), testName);

}  // namespace
}  // namespace glider::golden
