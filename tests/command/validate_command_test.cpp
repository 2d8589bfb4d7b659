// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// `glidercc build --validate`.

#include "tests/support/command.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>

namespace glider::tests {
namespace {

using testing::HasSubstr;

const std::string kBuild =
    "$GLIDERCC build " GLIDER_SOURCE_DIR "/missions/gallery/thermocline.mission --validate ";

TEST(Validated, SaysWhatIsProvedOfTheProgram) {
  const TemporaryFolder folder;
  const std::string output = (folder.path() / "mission").string();
  for (const char* how : {"--target host -O0", "--target ts7800", "--target cm4 -O1"}) {
    const Outcome built = runShell(kBuild + how + " -o " + output);
    EXPECT_EQ(built.status, 0) << built.err;
    EXPECT_THAT(built.out, HasSubstr("23 of 23 parts of the code for"));
  }
}

TEST(Validated, TheProgramIsTheSame) {
  const TemporaryFolder folder;
  const std::string path = folder.path().string();
  const Outcome built = runShell(kBuild + "--target ts7800 -q -o " + path + "/mission && cd " +
                                 path + " && mv mission with && " + "$GLIDERCC build " +
                                 GLIDER_SOURCE_DIR "/missions/gallery/thermocline.mission " +
                                 "--target ts7800 -o mission && cmp mission with");
  EXPECT_EQ(built.status, 0) << built.err;
  EXPECT_EQ(built.out, "");
}

TEST(Validated, IsForProgramsUpToLevel2) {
  for (const char* how : {"-O3", "--emit obj", "--emit ir", "--dialect extctl -o port"}) {
    const Outcome refused = runShell(kBuild + how);
    EXPECT_EQ(refused.status, 2) << how;
    EXPECT_THAT(refused.err, HasSubstr("--validate"));
  }
}

}  // namespace
}  // namespace glider::tests
