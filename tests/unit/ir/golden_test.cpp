// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/text/read.h"
#include "ir/verify/verify.h"
#include "support/diagnostics/render.h"
#include "support/files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

namespace glider::ir {
namespace {

namespace fs = std::filesystem;

/// A golden: a mission in text form, then the diagnostics it gives as comments below this line.
constexpr std::string_view kExpectation = "\n# ---- diagnostics\n";

std::vector<fs::path> goldens() {
  std::vector<fs::path> paths;
  for (const char* folder : {"verify", "ir_text"}) {
    for (const auto& entry :
         fs::directory_iterator(fs::path(GLIDER_SOURCE_DIR) / "tests/golden" / folder)) {
      if (entry.path().extension() == ".ir") {
        paths.push_back(entry.path());
      }
    }
  }
  std::ranges::sort(paths);
  return paths;
}

std::string commented(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const size_t end = std::min(text.find('\n'), text.size() - 1) + 1;
    out += (text.front() == '\n' ? "#" : "# ") + std::string(text.substr(0, end));
    text.remove_prefix(end);
  }
  return out;
}

std::string diagnosticsOf(const std::string& name, const std::string& input) {
  support::SourceManager sources;
  support::DiagnosticEngine diagnostics;
  const std::optional<Mission> mission = read(sources, sources.add(name, input), diagnostics);
  EXPECT_NE(mission.has_value(), diagnostics.hasErrors());
  if (mission) {
    verify(*mission, diagnostics);
  }
  return support::render(diagnostics, sources, false);
}

/// GLIDER_UPDATE_GOLDENS=1 in the environment rewrites the expectations.
class Golden : public testing::TestWithParam<fs::path> {};

TEST_P(Golden, GivesItsDiagnostics) {
  const auto file = support::readFile(GetParam());
  ASSERT_TRUE(file.has_value());
  const size_t split = std::min(file->find(kExpectation), file->size());
  const std::string input = file->substr(0, split);
  const std::string found =
      std::string(kExpectation) + commented(diagnosticsOf(GetParam().filename(), input));
  if (std::getenv("GLIDER_UPDATE_GOLDENS") != nullptr) {
    ASSERT_TRUE(support::writeFileAtomically(GetParam(), input + found).has_value());
  }
  const auto kept = support::readFile(GetParam());
  ASSERT_TRUE(kept.has_value());
  EXPECT_EQ(*kept, input + found) << "scripts/update_goldens writes what is said now";
}

TEST(Goldens, EachFolderHasSome) {
  const auto found = goldens();
  for (const char* folder : {"verify", "ir_text"}) {
    EXPECT_TRUE(std::ranges::any_of(found, [&](const fs::path& path) {
      return path.parent_path().filename() == folder;
    })) << folder;
  }
}

INSTANTIATE_TEST_SUITE_P(Ir, Golden, testing::ValuesIn(goldens()), [](const auto& golden) {
  return golden.param.parent_path().filename().string() + "_" + golden.param.stem().string();
});

}  // namespace
}  // namespace glider::ir
