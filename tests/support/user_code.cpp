// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/support/user_code.h"

#include "tests/support/command.h"

#include <gtest/gtest.h>

namespace glider::tests {

std::string compileFor(const std::string& board, const std::filesystem::path& mission,
                       const std::filesystem::path& source, const std::string& name,
                       const std::string& flags) {
  const std::filesystem::path folder = source.parent_path();
  const std::string object = (folder / name).string();
  const std::string header = (folder / mission.stem()).string() + ".h";
  const Outcome declared =
      runShell("$GLIDERCC build " + mission.string() + " --emit header -o " + header);
  EXPECT_EQ(declared.status, 0) << declared.err;
  const Outcome compiled = runShell(GLIDER_CLANGXX " $($GLIDERCC targets --cflags " + board +
                                    ") -std=c++20 -Wall -Wextra "
                                    "-Wpedantic -Werror " +
                                    flags + " -c " + source.string() + " -o " + object);
  EXPECT_EQ(compiled.status, 0) << compiled.err;
  return object;
}

}  // namespace glider::tests
