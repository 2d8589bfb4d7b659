// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Every mission in the documents is checked: a block ```mission must be fine, a block ```mission
// GL2003 must give that diagnostic (and fail if it is an error). A block ```fragment is a mission
// without its first line.

#include "tests/docs/examples.h"
#include "tests/support/command.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

namespace glider::tests {
namespace {

std::vector<Example> allExamples() {
  std::vector<Example> all;
  const std::filesystem::path root = GLIDER_SOURCE_DIR;
  std::vector<std::filesystem::path> pages = {root / "README.md"};
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root / "docs")) {
    if (entry.path().extension() == ".md") {
      pages.push_back(entry.path());
    }
  }
  for (const auto& page : pages) {
    const auto examples = examplesOf(page);
    all.insert(all.end(), examples.begin(), examples.end());
  }
  return all;
}

TEST(Documents, EveryMissionDoesWhatTheTextSays) {
  const auto examples = allExamples();
  ASSERT_GE(examples.size(), 5U) << "the documents have lost their examples";
  for (const Example& example : examples) {
    const TemporaryFolder folder;
    const auto path = folder.write("example.mission", example.text);
    for (const auto& [name, text] : example.files) {
      (void)folder.write(name, text);
    }
    const Outcome outcome = runShell("$GLIDERCC check " + path.string());
    const std::string place =
        example.file + ":" + std::to_string(example.line) + "\n" + outcome.err;
    if (example.expected.empty()) {
      EXPECT_EQ(outcome.status, 0) << place;
      EXPECT_EQ(outcome.err, "") << place;
    } else {
      EXPECT_NE(outcome.err.find("[" + example.expected + " "), std::string::npos) << place;
    }
  }
}

/// The vehicle would refuse or abort none of the missions of a page that shows its mission file.
TEST(Documents, MissionsGoWithTheMissionFileOfTheirPage) {
  constexpr const char* kVehicles = "slocum.mi";
  int tried = 0;
  for (const Example& example : allExamples()) {
    if (!example.files.contains(kVehicles) || !example.expected.empty()) {
      continue;
    }
    const TemporaryFolder folder;
    for (const auto& [name, text] : example.files) {
      (void)folder.write(name, text);
    }
    const auto path = folder.write("example.mission", example.text);
    const Outcome outcome = runShell("cd " + folder.path().string() + " && $GLIDERCC check --mi " +
                                     kVehicles + " " + path.string());
    EXPECT_EQ(outcome.status, 0) << example.file << ":" << example.line << "\n" << outcome.err;
    ++tried;
  }
  EXPECT_GE(tried, 13);
}

}  // namespace
}  // namespace glider::tests
