// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "support/diagnostics/engine.h"
#include "support/diagnostics/ids/files.h"
#include "support/diagnostics/render.h"

#include <gtest/gtest.h>

#include <set>

namespace glider::support {
namespace {

TEST(Diagnostics, ShowPlaceCaretHintAndId) {
  SourceManager sources;
  const uint32_t file = sources.add("a.mission", "mission m\n\tgoto s9\n");
  DiagnosticEngine engine;
  engine.report(support::diagnostics::cannotRead, {file, 16, 18}, "s9", "gone")
      .hint("states: s1")
      .note({file, 8, 9}, "in this mission");
  EXPECT_TRUE(engine.hasErrors());
  const std::string text = render(engine, sources, false);
  EXPECT_EQ(text.substr(0, text.find('\n')),
            "a.mission:2:7: error: " + engine.sorted()[0].message + " [GL9001 cannot-read]");
  EXPECT_NE(text.find("    2 |  goto s9\n      |       ^~\n"), std::string::npos) << text;
  EXPECT_NE(text.find("= hint: states: s1"), std::string::npos) << text;
  EXPECT_NE(text.find("a.mission:1:9: note: in this mission"), std::string::npos) << text;
}

TEST(Diagnostics, ColumnsCountCharactersNotBytes) {
  SourceManager sources;
  const uint32_t file = sources.add("a", "\xC3\xA9\xC3\xA9x\r\ny");
  EXPECT_EQ(sources.place(file, 4).column, 3U);
  EXPECT_EQ(sources.line(file, 1), "\xC3\xA9\xC3\xA9x");
  EXPECT_EQ(sources.place(file, 999).line, 2U);
}

TEST(Diagnostics, AreSortedAndNotRepeated) {
  SourceManager sources;
  const uint32_t file = sources.add("a", "0123456789");
  DiagnosticEngine engine;
  engine.report(support::diagnostics::cannotRead, {file, 5, 6}, "b", "gone");
  engine.report(support::diagnostics::cannotRead, {file, 1, 2}, "a", "gone");
  engine.report(support::diagnostics::cannotRead, {file, 5, 6}, "b", "gone");
  ASSERT_EQ(engine.sorted().size(), 2U);
  EXPECT_EQ(engine.sorted()[0].range.begin, 1U);
}

TEST(Diagnostics, CatalogueNumbersAndSlugsAreUnique) {
  std::set<int> numbers;
  std::set<std::string_view> slugs;
  for (const CatalogueRow& row : catalogue()) {
    EXPECT_TRUE(numbers.insert(static_cast<int>(row.id)).second) << code(row.id);
    EXPECT_TRUE(slugs.insert(row.slug).second) << row.slug;
    EXPECT_FALSE(row.message.ends_with('.')) << code(row.id);
  }
}

}  // namespace
}  // namespace glider::support
