// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>

/// The tests that the requirement tables name exist.
namespace glider::hooks {
namespace {

std::set<std::string> registeredTests() {
  std::set<std::string> names;
  const testing::UnitTest& all = *testing::UnitTest::GetInstance();
  for (int s = 0; s < all.total_test_suite_count(); ++s) {
    const testing::TestSuite& suite = *all.GetTestSuite(s);
    for (int t = 0; t < suite.total_test_count(); ++t) {
      names.insert(std::string(suite.name()) + "." + suite.GetTestInfo(t)->name());
    }
  }
  return names;
}

TEST(Requirements, EachNamesTestsThatExist) {
  const std::set<std::string> tests = registeredTests();
  for (const char* folder : {"hookbeh", "hookprog"}) {
    std::ifstream in(std::string(GLIDER_SOURCE_DIR "/hooks/") + folder + "/README.md");
    std::string line;
    int rows = 0;
    while (std::getline(in, line)) {
      if (!line.starts_with("| HB-") && !line.starts_with("| HP-")) {
        continue;
      }
      ++rows;
      const std::regex name("`(\\w+\\.\\w+)`");
      const std::sregex_iterator first(line.begin(), line.end(), name);
      EXPECT_NE(first, std::sregex_iterator()) << line;
      for (std::sregex_iterator match = first; match != std::sregex_iterator(); ++match) {
        EXPECT_TRUE(tests.contains((*match)[1])) << (*match)[1];
      }
    }
    EXPECT_GT(rows, 5) << folder;
  }
}

}  // namespace
}  // namespace glider::hooks
