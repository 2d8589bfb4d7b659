// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "support/files.h"

#include "tests/support/command.h"

#include <gtest/gtest.h>

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
  EXPECT_EQ(failed.error().id, DiagnosticId::cannotWrite);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
  EXPECT_FALSE(writeFileAtomically("/dev/full", "x"));
}

TEST(Files, ReadingWhatIsNoFileSaysWhy) {
  const tests::TemporaryFolder folder;
  EXPECT_FALSE(readFile(folder.path()));
  const auto missing = readFile(folder.path() / "missing");
  ASSERT_FALSE(missing);
  EXPECT_NE(missing.error().message.find("No such file"), std::string::npos);
  EXPECT_FALSE(readFile("/dev/zero")) << "an endless file must not be read for ever";
}

}  // namespace
}  // namespace glider::support
