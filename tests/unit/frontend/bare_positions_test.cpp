// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/bare_positions.h"

#include <gtest/gtest.h>

namespace glider::frontend {
namespace {

TEST(BarePositions, ThreeDigitsBeforeThePointOrZeroAreDdmm) {
  for (const char* plain : {"3910.5", "0039.1", "910", "0", "0.0", "000.5", "1e3"}) {
    EXPECT_TRUE(isPlainlyDdmm(plain)) << plain;
  }
  for (const char* open : {"39.1", "5", ".5", "99.9"}) {
    EXPECT_FALSE(isPlainlyDdmm(open)) << open;
  }
}

TEST(BarePositions, ALongitudeFirst) {
  EXPECT_TRUE(isLongitudeFirst(-73.83, 39.175));
  EXPECT_TRUE(isLongitudeFirst(-122.5, 36.8));
  EXPECT_TRUE(isLongitudeFirst(-122.5, 80));
  EXPECT_TRUE(isLongitudeFirst(70.01, 70));
  EXPECT_FALSE(isLongitudeFirst(70, 39)) << "70 itself is flown";
  EXPECT_FALSE(isLongitudeFirst(78, 71)) << "both are polar";
  EXPECT_FALSE(isLongitudeFirst(-77.5, 165)) << "165 is not a latitude";
  EXPECT_FALSE(isLongitudeFirst(39.175, -73.83));
  EXPECT_FALSE(isLongitudeFirst(190, 39)) << "not on Earth either way";
}

TEST(BarePositions, APairIsWrittenWithLettersAndTheLatitudeFirst) {
  EXPECT_EQ(pairWithLetters({"3910.6", false}, {"7349.9", true}), "39.176667 N 73.831667 W");
  EXPECT_EQ(pairWithLetters({"7349.9", true}, {"3910.6", false}), "39.176667 N 73.831667 W");
  EXPECT_EQ(pairWithLetters({"3355.2", true}, {"1825.4", false}), "33.92 S 18.423333 E");
  EXPECT_EQ(pairWithLetters({"3900", false}, {"000", false}), "39.0 N 0.0 E");
  EXPECT_EQ(pairWithLetters({"3960.0", false}, {"7349.9", true}), std::nullopt) << "60 minutes";
  EXPECT_EQ(pairWithLetters({"39.1", false}, {"7349.9", true}), std::nullopt);
  EXPECT_EQ(pairWithLetters({"12210.5", false}, {"12310.5", false}), std::nullopt);
  EXPECT_EQ(pairWithLetters({"18000.5", false}, {"3910.5", false}), std::nullopt);
}

TEST(BarePositions, APairByItsLooks) {
  EXPECT_TRUE(isPairByLooks("3910.6", "7349.9", true, false));
  EXPECT_TRUE(isPairByLooks("3910.6", "7349.9", true, true));
  EXPECT_TRUE(isPairByLooks("3910.6", "7349.9", false, false));
  EXPECT_TRUE(isPairByLooks("3910", "7349", true, false));
  EXPECT_FALSE(isPairByLooks("3910", "7349", true, true)) << "whole numbers, blanks on both sides";
  EXPECT_FALSE(isPairByLooks("3910", "7349", false, false));
  EXPECT_FALSE(isPairByLooks("10", "3", true, false));
  EXPECT_FALSE(isPairByLooks("3910.6", "7375.9", true, false)) << "75 minutes";
}

}  // namespace
}  // namespace glider::frontend
