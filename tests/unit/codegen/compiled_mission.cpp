// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/unit/codegen/compiled_mission.h"

#include "ir/text/read.h"
#include "ir/verify/verify.h"
#include "platforms/load/load_platform.h"
#include "support/check.h"
#include "support/files.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace glider::codegen_tests {

namespace fs = std::filesystem;

Checked checkedMission(const std::string& text, const std::string& name) {
  Checked checked;
  support::DiagnosticEngine diagnostics;
  const uint32_t file = checked.sources.add(name, text);
  auto mission = ir::read(checked.sources, file, diagnostics);
  CHECK(mission.has_value(), "a test's mission that cannot be read");
  checked.mission = std::move(*mission);
  checked.facts = ir::verify(checked.mission, diagnostics);
  CHECK(!diagnostics.hasErrors(), "a test's mission with errors");
  auto platform = platforms::loadPlatform(GLIDER_SOURCE_DIR "/platforms/slocum.toml");
  CHECK(platform.has_value(), "slocum.toml cannot be read");
  checked.platform = std::move(*platform);
  return checked;
}

Checked figure2() {
  const auto text = support::readFile(GLIDER_SOURCE_DIR "/tests/golden/verify/ok_figure2.ir");
  CHECK(text.has_value(), "ok_figure2.ir is missing");
  return checkedMission(*text, "figure2.ir");
}

platforms::Board board(const std::string& name) {
  auto loaded = platforms::loadBoard(fs::path(GLIDER_BINARY_DIR) / "share/glidercc/boards" / name /
                                     "board.toml");
  CHECK(loaded.has_value(), loaded.error().message.c_str());
  return *loaded;
}

fs::path testFolder() {
  const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
  std::string name = fmt::format("{}.{}", test->test_suite_name(), test->name());
  std::ranges::replace(name, '/', '-');
  const fs::path folder = fs::path(GLIDER_BINARY_DIR) / "tests" / "codegen-files" / name;
  fs::remove_all(folder);
  fs::create_directories(folder);
  return folder;
}

}  // namespace glider::codegen_tests
