// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/spelling.h"

#include <gtest/gtest.h>

namespace glider::frontend {
namespace {

TEST(Spelling, Distance) {
  EXPECT_EQ(editDistance("depth", "depth"), 0U);
  EXPECT_EQ(editDistance("depht", "depth"), 1U);
  EXPECT_EQ(editDistance("", "abc"), 3U);
  EXPECT_EQ(editDistance("temp", "tmp"), 1U);
  EXPECT_EQ(editDistance("kitten", "sitting"), 3U);
}

TEST(Spelling, Closest) {
  EXPECT_EQ(closest("tmp", {"depth", "temp"}), "temp");
  EXPECT_EQ(closest("DEPTH", {"depth", "temp"}), "depth");
  EXPECT_EQ(closest("x", {"depth", "temp"}), "");
  EXPECT_EQ(closest("altitude", {"depth", "temp"}), "");
  EXPECT_EQ(closest("abc", {}), "");
  EXPECT_EQ(didYouMean("tmp", {"temp"}, "no"), "did you mean `temp`?");
  EXPECT_EQ(didYouMean("zzz", {"temp"}, "no"), "no");
}

TEST(Spelling, UnitWords) {
  EXPECT_EQ(unitForWord("metres"), "m");
  EXPECT_EQ(unitForWord("Hours"), "h");
  EXPECT_EQ(unitForWord("C"), "degC");
  EXPECT_EQ(unitForWord("KM"), "km");
  EXPECT_EQ(unitForWord("parsec"), "");
}

}  // namespace
}  // namespace glider::frontend
