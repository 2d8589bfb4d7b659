// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The conditions about which something was reported.

#include "ir/prove/said_ranges.h"

#include <gtest/gtest.h>

namespace glider::ir::prove {
namespace {

SaidRanges saidOf(std::initializer_list<support::SourceRange> ranges) {
  SaidRanges said;
  for (const support::SourceRange& range : ranges) {
    said.add(range);
  }
  return said;
}

TEST(SaidRanges, CoverWhatLiesWithinOne) {
  const SaidRanges said = saidOf({{0, 10, 20}, {0, 30, 40}});
  EXPECT_TRUE(said.cover({0, 10, 20}));
  EXPECT_TRUE(said.cover({0, 12, 15}));
  EXPECT_TRUE(said.cover({0, 38, 40}));
  EXPECT_FALSE(said.cover({0, 10, 21}));
  EXPECT_FALSE(said.cover({0, 9, 12}));
  EXPECT_FALSE(said.cover({0, 22, 25}));
  EXPECT_FALSE(said.cover({0, 45, 46}));
  EXPECT_FALSE(said.cover({1, 12, 15}));
  EXPECT_FALSE(SaidRanges().cover({0, 0, 1}));
}

TEST(SaidRanges, KeepTheOutermostInEitherOrder) {
  for (const SaidRanges& said : {saidOf({{0, 10, 50}, {0, 20, 30}, {0, 10, 15}}),
                                 saidOf({{0, 10, 15}, {0, 20, 30}, {0, 10, 50}})}) {
    EXPECT_TRUE(said.cover({0, 40, 45}));
    EXPECT_TRUE(said.cover({0, 10, 50}));
    EXPECT_FALSE(said.cover({0, 10, 51}));
  }
}

TEST(SaidRanges, ConcernWhatHasOneWithinIt) {
  const SaidRanges said = saidOf({{1, 10, 20}});
  EXPECT_TRUE(said.concern({1, 0, 30}));
  EXPECT_TRUE(said.concern({1, 10, 20}));
  EXPECT_TRUE(said.concern({1, 12, 13}));
  EXPECT_FALSE(said.concern({1, 20, 30}));
  EXPECT_FALSE(said.concern({1, 0, 10}));
  EXPECT_FALSE(said.concern({1, 15, 25}));
  EXPECT_FALSE(said.concern({0, 0, 30}));
  EXPECT_FALSE(said.concern({2, 0, 30}));
}

}  // namespace
}  // namespace glider::ir::prove
