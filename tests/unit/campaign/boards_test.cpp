// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Which boards' binaries can fly here.

#include "campaign/campaign.h"
#include "tests/support/command.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <gmock/gmock.h>

namespace glider::campaign {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// A share folder with the boards as they are, and a PATH of two folders.
class BoardsHere : public ::testing::Test {
 protected:
  BoardsHere() : path_(std::getenv("PATH")) {
    for (const char* name : {"host", "ts5500", "ts7800"}) {
      fs::create_directories(folder_.path() / "boards" / name);
      fs::copy(fs::path(GLIDER_SOURCE_DIR) / "platforms/boards" / (std::string(name) + ".toml"),
               boardFile(name));
    }
    fs::create_directory(folder_.path() / "one");
    fs::create_directory(folder_.path() / "two");
    setenv("GLIDERCC_SHARE", folder_.path().c_str(), 1);
    setenv("PATH",
           (folder_.path() / "one").string().append(":").append(folder_.path() / "two").c_str(), 1);
  }
  ~BoardsHere() override {
    setenv("PATH", path_.c_str(), 1);
    unsetenv("GLIDERCC_SHARE");
  }

  [[nodiscard]] fs::path boardFile(const std::string& name) const {
    return folder_.path() / "boards" / name / "board.toml";
  }
  /// A file of that name, which can be run or not.
  [[nodiscard]] std::string program(const std::string& name, bool runs = true) const {
    const fs::path file = folder_.write(name, "#!/bin/sh\n");
    fs::permissions(file, runs ? fs::perms::owner_all : fs::perms::owner_read);
    return file.string();
  }
  std::vector<std::string> here() {
    missing_.clear();
    return boardsHere(missing_);
  }

  const tests::TemporaryFolder folder_;
  const std::string path_;
  std::vector<std::string> missing_;
};

TEST_F(BoardsHere, AreThoseWhoseEmulatorIsFound) {
  EXPECT_THAT(here(), IsEmpty());
  EXPECT_THAT(missing_, ElementsAre("`qemu-i386`, which runs the binaries of ts5500",
                                    "`qemu-arm`, which runs the binaries of ts7800"));
  (void)program("two/qemu-arm");
  EXPECT_THAT(here(), ElementsAre("ts7800"));
  EXPECT_THAT(missing_, ElementsAre("`qemu-i386`, which runs the binaries of ts5500"));
  (void)program("one/qemu-i386");
  EXPECT_THAT(here(), ElementsAre("ts5500", "ts7800"));
  EXPECT_THAT(missing_, IsEmpty());
}

TEST_F(BoardsHere, AFileThatCannotBeRunIsNotAnEmulator) {
  fs::create_directory(folder_.path() / "one" / "qemu-i386.not");
  (void)program("one/qemu-arm", false);
  EXPECT_THAT(here(), IsEmpty());
}

TEST_F(BoardsHere, WithoutAPathThereAreNone) {
  unsetenv("PATH");
  EXPECT_THAT(here(), IsEmpty());
}

TEST_F(BoardsHere, AnEmulatorMayBeNamedByItsPlace) {
  std::string text = tests::slurp(boardFile("ts7800"));
  const size_t at = text.find("\"qemu-arm\"");
  ASSERT_NE(at, std::string::npos);
  const std::string elsewhere = program("elsewhere");
  text.replace(at, 10, "\"" + elsewhere + "\"");
  (void)folder_.write("boards/ts7800/board.toml", text);
  EXPECT_THAT(here(), ElementsAre("ts7800"));
  fs::remove(elsewhere);
  EXPECT_THAT(here(), IsEmpty());
}

}  // namespace
}  // namespace glider::campaign
