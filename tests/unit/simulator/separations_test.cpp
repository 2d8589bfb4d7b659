// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The distances between the vehicles of a fleet.

#include "simulator/fleet/separations.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <vector>

namespace glider::simulator {
namespace {

using Places = std::vector<std::optional<TruePlace>>;

TEST(Separations, TheLeastIsAlongTheStraightLineWithItsTimeAndDepths) {
  Separations all(2);
  all.look(0, Places{TruePlace{0, 0, 0}, TruePlace{300, 400, 0}});
  all.look(1, Places{TruePlace{0, 0, 10}, TruePlace{20, 30, 70}});
  all.look(2, Places{TruePlace{0, 0, 0}, TruePlace{0, 71, 0}});
  const PairDistance& pair = all.pairs().at(0);
  EXPECT_EQ(pair.least_m, 70);  // 20, 30 and 60
  EXPECT_EQ(pair.least_at_s, 1);
  EXPECT_EQ(pair.least_depths_m[0], 10);
  EXPECT_EQ(pair.least_depths_m[1], 70);
}

TEST(Separations, OneThatDoesNotFlyDoesNotCount) {
  Separations all(3);
  all.look(0, Places{TruePlace{}, std::nullopt, TruePlace{5, 0, 0}});
  EXPECT_TRUE(std::isinf(all.pairs()[0].least_m)) << "0 and 1";
  EXPECT_EQ(all.pairs()[1].least_m, 5) << "0 and 2";
  EXPECT_TRUE(std::isinf(all.pairs()[2].least_m)) << "1 and 2";
}

TEST(Separations, TheSeriesHasTheLeastSinceTheTimeBefore) {
  Separations all(2);
  for (int second = 0; second <= 120; ++second) {
    const double apart = second == 30 ? 7 : 100;
    all.look(second, Places{TruePlace{}, TruePlace{apart, 0, 0}});
  }
  EXPECT_EQ(all.times(), (std::vector<double>{0, 60, 120}));
  EXPECT_EQ(all.series(0), (std::vector<double>{100, 7, 100}));
}

/// Ten days: the series stays short, and loses no least.
TEST(Separations, ALongSeriesIsThinnedAndKeepsTheLeast) {
  Separations all(2);
  constexpr int kMinutes = 14400;
  for (int minute = 0; minute <= kMinutes; ++minute) {
    const double apart = minute == 3001 ? 2 : 50;
    all.look(60.0 * minute, Places{TruePlace{}, TruePlace{apart, 0, 0}});
  }
  EXPECT_LE(all.times().size(), Separations::kMostSamples);
  EXPECT_GT(all.times().size(), Separations::kMostSamples / 4);
  ASSERT_EQ(all.times().size(), all.series(0).size());
  size_t near = 0;
  for (size_t i = 0; i < all.times().size(); ++i) {
    if (all.series(0)[i] == 2) {
      ++near;
      EXPECT_GE(all.times()[i], 60.0 * 3001);
      EXPECT_LT(i == 0 ? -1 : all.times()[i - 1], 60.0 * 3001);
    }
  }
  EXPECT_EQ(near, 1U);
}

}  // namespace
}  // namespace glider::simulator
