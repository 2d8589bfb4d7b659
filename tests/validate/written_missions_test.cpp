// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The missions of the gallery, on every board.

#include "compiler/compilation.h"
#include "tests/validate/built.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <vector>

namespace glider::validate_test {
namespace {

std::vector<std::string> gallery() {
  std::vector<std::string> names;
  for (const auto& entry :
       std::filesystem::directory_iterator(GLIDER_SOURCE_DIR "/missions/gallery")) {
    if (entry.path().extension() == ".mission") {
      names.push_back(entry.path().stem());
    }
  }
  std::ranges::sort(names);
  return names;
}

class GalleryValidated : public testing::TestWithParam<std::string> {};

TEST_P(GalleryValidated, CodeDoesWhatTheMissionMeans) {
  const auto compilation = compiler::compileMission(
      fmt::format("{}/missions/gallery/{}.mission", GLIDER_SOURCE_DIR, GetParam()));
  ASSERT_TRUE(compilation && compilation->checked);
  const compiler::Optimised mission = compiler::optimise(compilation->checked);
  for (const char* board : {"host", "ts7800", "ts5500", "cm4"}) {
    const auto found = validate(mission.input(), board, 2);
    EXPECT_GT(found.size(), 8U);
    EXPECT_EQ(whatIsNotSame(found), "") << board;
  }
}

INSTANTIATE_TEST_SUITE_P(Missions, GalleryValidated, testing::ValuesIn(gallery()),
                         [](const auto& param) { return param.param; });

}  // namespace
}  // namespace glider::validate_test
