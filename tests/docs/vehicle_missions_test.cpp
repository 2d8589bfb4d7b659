// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The commands of the documents: a block ```mi NAME is written to that file, a block ```mission to
// one of the mission's name, and a block ```console is what commands (lines that begin with `$ `)
// print beside these files. In ```console fails the last one fails. A line of the block that is
// only `…` stands for any lines.

#include "tests/support/command.h"

#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <string_view>

namespace glider::tests {
namespace {

constexpr std::string_view kAnyLines = "…\n";

/// Whether `text` is `shown`, in which a line `…` stands for any lines.
bool isShown(const std::string& text, const std::string& shown) {
  size_t at = 0;
  for (size_t from = 0;;) {
    const size_t gap = shown.find(kAnyLines, from);
    const std::string part = shown.substr(from, gap == std::string::npos ? gap : gap - from);
    const bool last = gap == std::string::npos;
    if (last && from > 0) {
      return text.size() >= at + part.size() && text.ends_with(part);
    }
    if (last) {
      return text == part;
    }
    const size_t found =
        from == 0 ? (text.starts_with(part) ? 0 : std::string::npos) : text.find(part, at);
    if (found == std::string::npos) {
      return false;
    }
    at = found + part.size();
    from = gap + kAnyLines.size();
  }
}

class Page {
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
      } else if (line.starts_with("```mission")) {
        in_file = true;
        file.clear();
        text.clear();
      } else {
        in_console = line.starts_with("```console");
        fails_ = line == "```console fails";
      }
    }
    readMissionFiles();
    return commands_;
  }

 private:
  /// Every mission file of the vehicle is one.
  void readMissionFiles() const {
    for (const auto& entry : std::filesystem::directory_iterator(folder_.path())) {
      if (entry.path().extension() == ".mi") {
        const Outcome outcome = runShell("$GLIDERCC mi " + entry.path().string());
        EXPECT_EQ(outcome.status, 0) << entry.path() << outcome.err;
        EXPECT_EQ(outcome.err, "") << entry.path();
      }
    }
  }

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
    compare(false);
    command_ = line.substr(2);
  }

  /// What is printed on both streams, as in a terminal.
  void compare(bool last = true) {
    if (!command_.empty()) {
      constexpr std::string_view kName = "glidercc";
      ASSERT_TRUE(command_.starts_with(kName)) << command_;
      const Outcome outcome = runShell("cd " + folder_.path().string() + " && $GLIDERCC" +
                                       command_.substr(kName.size()) + " 2>&1");
      EXPECT_EQ(outcome.status, last && fails_ ? 1 : 0) << command_;
      EXPECT_TRUE(isShown(outcome.out, expected_)) << command_ << " prints\n"
                                                   << outcome.out << "instead of\n"
                                                   << expected_;
      ++commands_;
    }
    command_.clear();
    expected_.clear();
  }

  const TemporaryFolder folder_;
  std::string command_, expected_;
  bool fails_ = false;
  int commands_ = 0;
};

TEST(Documents, CommandsPrintWhatThePagesShow) {
  int commands = 0;
  for (const auto& page : std::filesystem::directory_iterator(GLIDER_SOURCE_DIR "/docs")) {
    if (page.path().extension() == ".md") {
      SCOPED_TRACE(page.path().filename().string());
      commands += Page().follow(page.path());
    }
  }
  EXPECT_GE(commands, 15);
}

TEST(Documents, ALineOfDotsStandsForAnyLines) {
  EXPECT_TRUE(isShown("a\nb\nc\n", "a\nb\nc\n"));
  EXPECT_TRUE(isShown("a\nb\nc\n", "a\n…\n"));
  EXPECT_TRUE(isShown("a\nb\nc\n", "…\nc\n"));
  EXPECT_TRUE(isShown("a\nb\nc\n", "a\n…\nc\n"));
  EXPECT_TRUE(isShown("a\nb\nc\n", "…\nb\n…\n"));
  for (const char* shown : {"a\n", "a\n…\nb\n", "b\n…\n", "…\nd\n…\n", "…\nc\n…\nb\n…\n"}) {
    EXPECT_FALSE(isShown("a\nb\nc\n", shown)) << shown;
  }
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
