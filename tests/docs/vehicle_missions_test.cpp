// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The guide's commands: a block ```mi NAME is written to that file, a block ```mission to one of
// the mission's name, and a block ```console is what commands (lines that begin with `$ `) print
// beside these files.

#include "tests/support/command.h"

#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <string_view>

namespace glider::tests {
namespace {

class Guide {
 public:
  /// Does what the blocks of `page` say; returns the number of commands.
  int follow(const std::filesystem::path& page) {
    std::ifstream in(page);
    std::string line, file, text;
    bool in_file = false, in_console = false;
    while (std::getline(in, line)) {
      if (line.starts_with("```") && (in_file || in_console)) {
        in_file ? (void)folder_.write(file.empty() ? nameOf(text) : file, text) : compare();
        in_file = in_console = false;
      } else if (in_file) {
        text += line + "\n";
      } else if (in_console) {
        console(line);
      } else if (line.starts_with("```mi ")) {
        in_file = true;
        file = line.substr(std::string_view("```mi ").size());
        text.clear();
      } else if (line == "```mission") {
        in_file = true;
        file.clear();
        text.clear();
      } else {
        in_console = line == "```console";
      }
    }
    return commands_;
  }

 private:
  /// "hotspot.mission" of a text whose first line is "mission hotspot".
  static std::string nameOf(const std::string& text) {
    constexpr std::string_view kFirst = "mission ";
    const std::string line = text.substr(0, text.find('\n'));
    return (line.starts_with(kFirst) ? line.substr(kFirst.size()) : "unnamed") + ".mission";
  }

  void console(const std::string& line) {
    if (!line.starts_with("$ ")) {
      expected_ += line + "\n";
      return;
    }
    compare();
    command_ = line.substr(2);
  }

  void compare() {
    if (!command_.empty()) {
      constexpr std::string_view kName = "glidercc";
      ASSERT_TRUE(command_.starts_with(kName)) << command_;
      const Outcome outcome = runShell("cd " + folder_.path().string() + " && $GLIDERCC" +
                                       command_.substr(kName.size()));
      EXPECT_EQ(outcome.status, 0) << command_;
      EXPECT_EQ(outcome.out, expected_) << command_;
      EXPECT_EQ(outcome.err, "") << command_;
      ++commands_;
    }
    command_.clear();
    expected_.clear();
  }

  const TemporaryFolder folder_;
  std::string command_, expected_;
  int commands_ = 0;
};

TEST(Documents, CommandsPrintWhatTheGuideShows) {
  EXPECT_GE(Guide().follow(std::filesystem::path(GLIDER_SOURCE_DIR) / "docs/guide.md"), 3);
}

/// Of the page's two files, the first is refused for what the page explains, the second is not.
TEST(Documents, ThePageOfWhatMayStayBelowRefusesItsFirstFileOnly) {
  std::ifstream in(GLIDER_SOURCE_DIR "/support/diagnostics/explain/GL3127.md");
  const TemporaryFolder folder;
  std::string file, text;
  int tried = 0;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("```mi ")) {
      file = line.substr(std::string_view("```mi ").size());
      text.clear();
    } else if (line == "```" && !file.empty()) {
      const Outcome outcome =
          runShell("$GLIDERCC check --mi " + folder.write(file, text).string() +
                   " " GLIDER_SOURCE_DIR "/missions/gallery/thermocline.mission");
      EXPECT_EQ(outcome.status, tried == 0 ? 1 : 0) << file << outcome.err;
      EXPECT_EQ(outcome.err.find("[GL3127 ") != std::string::npos, tried == 0) << outcome.err;
      ++tried;
      file.clear();
    } else {
      text += line + "\n";
    }
  }
  EXPECT_EQ(tried, 2);
}

}  // namespace
}  // namespace glider::tests
