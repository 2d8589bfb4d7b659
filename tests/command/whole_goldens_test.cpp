// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Goldens of the vehicle's own mission files: below each, in lines that begin with `#| `, what
// `check --mi` says of it on standard error; below a mission what `check --scenario default` says.
// accepts: GL3124 GL3125 GL3126

#include "tests/support/command.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <string>
#include <string_view>

namespace glider::tests {
namespace {

const std::string kFolder = GLIDER_SOURCE_DIR "/tests/golden/whole";
constexpr const char* kMission = "../../../missions/gallery/thermocline.mission";

std::string expectedOf(const std::filesystem::path& golden) {
  constexpr std::string_view kMark = "#|";
  std::ifstream in(golden);
  std::string expected;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with(kMark)) {
      expected += line.size() > kMark.size() ? line.substr(kMark.size() + 1) + "\n" : "\n";
    }
  }
  return expected;
}

TEST(WholeGoldens, SayWhatMayStayUnderWater) {
  int refused = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kFolder)) {
    const std::string name = entry.path().filename().string();
    const std::string how =
        name.ends_with(".mission") ? "--scenario default " + name : "--mi " + name + " " + kMission;
    const Outcome outcome = runShell("cd " + kFolder + " && $GLIDERCC check --no-cache " + how);
    const bool fails = name.starts_with("fail_");
    refused += fails;
    EXPECT_EQ(outcome.status, fails ? 1 : 0) << name << outcome.err;
    const std::string expected = expectedOf(entry.path());
    EXPECT_EQ(expected.empty(), !fails) << name;
    EXPECT_THAT(outcome.err, testing::StartsWith(expected)) << name;
    EXPECT_EQ(outcome.err.find("GL312") != std::string::npos, fails) << name << outcome.err;
  }
  EXPECT_GE(refused, 3);
}

TEST(WholeGoldens, TheReportHasALineForEachEnding) {
  const Outcome outcome =
      runShell("cd " + kFolder +
               " && $GLIDERCC check --report --target host --skeleton " GLIDER_SOURCE_DIR
               "/scenarios/skeleton.mi " +
               kMission);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, testing::HasSubstr("\nafter silence of the SBC the vehicle is at the "
                                              "surface within 14 min 4 s, by behaviour 3 "
                                              "`surface` (start_when 1): silence_secs 24 s"));
}

}  // namespace
}  // namespace glider::tests
