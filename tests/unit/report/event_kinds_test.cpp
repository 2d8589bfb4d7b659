// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "support/files.h"

#include <gtest/gtest.h>

#include <regex>
#include <set>
#include <string>

// The page is TypeScript and cannot include the list of kinds.
namespace glider::report {
namespace {

using Kinds = std::set<std::string>;

std::string textOfFile(const char* path) {
  return support::readFile(std::string(GLIDER_SOURCE_DIR) + "/" + path).value();
}

/// The first group of each match of `pattern`.
Kinds allIn(const std::string& text, const std::string& pattern) {
  const std::regex regex(pattern);
  Kinds found;
  for (std::sregex_iterator at(text.begin(), text.end(), regex), end; at != end; ++at) {
    found.insert((*at)[1]);
  }
  return found;
}

TEST(EventKinds, OfThePageAreThoseOfTheList) {
  const Kinds listed = {
#define EVENT_KIND(name, word) word,
#include "support/trace/event_kinds.def"
#undef EVENT_KIND
  };
  const Kinds shown = allIn(textOfFile("report/page/src/kinds.ts"), R"(\n  (\w+): \{ colour:)");
  EXPECT_GT(shown.size(), 5U);
  for (const std::string& kind : shown) {
    EXPECT_TRUE(listed.contains(kind)) << kind;
  }
}

TEST(EventKinds, ThatAreMarkedAreThoseOfTheReadme) {
  const std::string page = textOfFile("report/page/src/kinds.ts");
  std::string readme = textOfFile("report/README.md");
  readme.erase(0, readme.find("Events of kind "));
  const std::string marked = readme.substr(0, readme.find("are marked"));
  const std::string flagged = readme.substr(marked.size(), readme.find("by flags") - marked.size());
  EXPECT_EQ(allIn(marked, "`(\\w+)`"), allIn(page, R"(\n  (\w+): \{.*marked: true)"));
  EXPECT_EQ(allIn(flagged, "`(\\w+)`"), allIn(page, R"(\n  (\w+): \{.*flagged: true)"));
}

TEST(EventKinds, HaveTheirColours) {
  const std::string page = textOfFile("report/page/src/kinds.ts");
  const Kinds colours = allIn(textOfFile("report/page/src/style.css"), R"(--(kind-\w+):)");
  for (const std::string& colour : allIn(page, R"re(colour: "([\w-]+)")re")) {
    EXPECT_TRUE(colours.contains(colour)) << colour;
  }
}

}  // namespace
}  // namespace glider::report
