// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "support/files.h"

#include "support/diagnostics/ids/files.h"
#include "tests/support/command.h"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <string>
#include <sys/stat.h>
#include <unistd.h>

namespace glider::support {
namespace {

TEST(Files, WriteReplacesWholly) {
  const tests::TemporaryFolder folder;
  const auto path = folder.write("f", "old and long");
  ASSERT_TRUE(writeFileAtomically(path, "new"));
  EXPECT_EQ(*readFile(path), "new");
}

TEST(Files, FailedWriteLeavesNothingBehind) {
  const tests::TemporaryFolder folder;
  const auto failed = writeFileAtomically(folder.path() / "none" / "f", "x");
  ASSERT_FALSE(failed);
  EXPECT_EQ(failed.error().id, support::diagnostics::cannotWrite);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
  EXPECT_FALSE(writeFileAtomically("/dev/full", "x"));
}

TEST(Files, ALinkStaysALinkAndItsTargetIsWritten) {
  namespace fs = std::filesystem;
  const tests::TemporaryFolder folder;
  const auto file = folder.write("file", "old");
  fs::create_directory(folder.path() / "sub");
  fs::create_symlink("../file", folder.path() / "sub" / "near");
  fs::create_symlink(folder.path() / "sub" / "near", folder.path() / "far");
  fs::create_symlink("not-yet", folder.path() / "dangling");
  ASSERT_TRUE(writeFileAtomically(folder.path() / "far", "new"));
  EXPECT_TRUE(fs::is_symlink(folder.path() / "far"));
  EXPECT_TRUE(fs::is_symlink(folder.path() / "sub" / "near"));
  EXPECT_EQ(*readFile(file), "new");
  ASSERT_TRUE(writeFileAtomically(folder.path() / "dangling", "there"));
  EXPECT_TRUE(fs::is_symlink(folder.path() / "dangling"));
  EXPECT_EQ(*readFile(folder.path() / "not-yet"), "there");
  fs::create_symlink("round", folder.path() / "round");
  EXPECT_FALSE(writeFileAtomically(folder.path() / "round", "x")) << "a link to itself";
  const auto behind = writeFileAtomically(folder.path() / "round" / "file", "x");
  ASSERT_FALSE(behind) << "in a folder that is a link to itself";
  EXPECT_NE(behind.error().message.find("Too many levels of symbolic links"), std::string::npos);
}

/// As `-o /dev/stdout` when standard output is a file; here by a descriptor's name in a folder of
/// the test, for /dev is not to be tried on.
TEST(Files, TheNameOfADescriptorIsWrittenToAsItIs) {
  const tests::TemporaryFolder folder;
  const auto file = folder.write("out", "before,");
  const int descriptor = ::open(file.c_str(), O_RDWR);
  ASSERT_GE(descriptor, 0);
  const auto link = folder.path() / "stdout";
  std::filesystem::create_symlink("/proc/self/fd/" + std::to_string(descriptor), link);
  for (const std::filesystem::path& name :
       {link, std::filesystem::path("/dev/fd/" + std::to_string(descriptor))}) {
    EXPECT_FALSE(isReplaceable(name));
    EXPECT_TRUE(writeFileAtomically(name, "x"));
  }
  EXPECT_TRUE(std::filesystem::is_symlink(link));
  struct stat open_file{};
  struct stat named_file{};
  ASSERT_EQ(::fstat(descriptor, &open_file), 0);
  ASSERT_EQ(::stat(file.c_str(), &named_file), 0);
  EXPECT_EQ(open_file.st_ino, named_file.st_ino) << "the file was replaced";
  ::close(descriptor);
  EXPECT_EQ(*readFile(file), "before,xx");
}

TEST(Files, WhatWasStagedAndNotPublishedIsGone) {
  const tests::TemporaryFolder folder;
  const auto path = folder.write("f", "old");
  {
    ASSERT_TRUE(StagedFile::write(path, "new", FileKind::Product));
  }
  EXPECT_EQ(*readFile(path), "old");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

TEST(Files, ReadingSomethingOtherThanAFileSaysWhy) {
  const tests::TemporaryFolder folder;
  EXPECT_FALSE(readFile(folder.path()));
  const auto missing = readFile(folder.path() / "missing");
  ASSERT_FALSE(missing);
  EXPECT_NE(missing.error().message.find("No such file"), std::string::npos);
  EXPECT_FALSE(readFile("/dev/zero")) << "an endless file must not be read for ever";
}

}  // namespace
}  // namespace glider::support
