// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Random missions on every board against ir/eval, every other one optimised before it is compiled.
// GLIDER_DIFFERENTIAL_COUNT and GLIDER_DIFFERENTIAL_SEED widen it: scripts/soak/differential.

#include "tests/differential/judge.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <tuple>

namespace glider::differential {
namespace {

constexpr size_t kBatch = 50;  // missions a program
constexpr size_t kTicks = 120;

uint64_t setting(const char* name, uint64_t otherwise) {
  const char* text = std::getenv(name);
  return text != nullptr ? std::strtoull(text, nullptr, 10) : otherwise;
}

class RandomMissionsJudged : public testing::TestWithParam<std::tuple<const char*, int>> {};

TEST_P(RandomMissionsJudged, AgreesWithEval) {
  const auto [board, level] = GetParam();
  const uint64_t first = setting("GLIDER_DIFFERENTIAL_SEED", 1);
  const uint64_t count = setting("GLIDER_DIFFERENTIAL_COUNT", 20);
  for (uint64_t begin = 0; begin < count; begin += kBatch) {
    std::vector<Trial> trials;
    for (uint64_t i = begin; i < std::min(count, begin + kBatch); ++i) {
      trials.push_back(randomTrial(first + i, kTicks, i % 2 == 1));
    }
    ASSERT_EQ(judge(trials, board, level), "");
  }
}

INSTANTIATE_TEST_SUITE_P(Boards, RandomMissionsJudged,
                         testing::Combine(testing::Values("host", "ts7800", "ts5500", "pizero2",
                                                          "cm4"),
                                          testing::Values(0, 2, 3)),
                         [](const auto& param) {
                           return fmt::format("{}_O{}", std::get<0>(param.param),
                                              std::get<1>(param.param));
                         });

}  // namespace
}  // namespace glider::differential
