// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// One test a golden: tests/golden/<stage>/{ok,warn,fail}_*. With GLIDER_UPDATE_GOLDENS set, what is
// expected is rewritten instead (scripts/update_goldens).

#include "tests/golden/golden_file.h"
#include "tests/golden/stages.h"

#include <gtest/gtest.h>

#include <cctype>
#include <cstdlib>
#include <string>

namespace glider::golden {
namespace {

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
  } else {
    EXPECT_EQ(outcome.text, golden.expected()) << "scripts/update_goldens writes what is said now";
  }
}

std::vector<std::filesystem::path> all() {
  std::vector<std::filesystem::path> found;
  for (const char* stage : {"parse", "sema", "verify", "prove"}) {
    const auto some =
        goldensIn(std::filesystem::path(GLIDER_SOURCE_DIR) / "tests" / "golden" / stage);
    found.insert(found.end(), some.begin(), some.end());
  }
  return found;
}

std::string testName(const testing::TestParamInfo<std::filesystem::path>& info) {
  std::string name =
      info.param.parent_path().filename().string() + "_" + info.param.stem().string();
  for (char& c : name) {
    c = std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  }
  return name;
}

INSTANTIATE_TEST_SUITE_P(Files, Golden, testing::ValuesIn(all()), testName);
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(Golden);

}  // namespace
}  // namespace glider::golden
