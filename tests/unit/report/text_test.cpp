// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "report/text.h"

#include <gtest/gtest.h>

namespace glider::report {
namespace {

TEST(Text, ControlCharactersBecomeQuestionMarks) {
  EXPECT_EQ(plain("a\x1b[31mb\nc\x7f"), "a?[31mb?c?");
  EXPECT_EQ(plain("a\xc2\x9b"
                  "31m"),
            "a?31m")
      << "the one-character escape U+009B";
  EXPECT_EQ(plain("zone 5 °C → s2"), "zone 5 °C → s2");
}

TEST(Text, WidthCountsCodePoints) {
  EXPECT_EQ(width("s1 → s2"), 7U);
  EXPECT_EQ(padded("→", 3), "→  ");
  EXPECT_EQ(padded("long", 2), "long");
}

TEST(Text, CutNeverSplitsACodePoint) {
  EXPECT_EQ(cut("→→→→", 4), "→→→→");
  EXPECT_EQ(cut("→→→→", 3), "→→…");
}

TEST(Text, WrapsAtSpacesAndInsideLongWords) {
  EXPECT_EQ(wrapped("one two three", 8, 2), "one two\n  three\n");
  EXPECT_EQ(wrapped("abcdefghijkl", 6, 2), "abcdef\n  ghij\n  kl\n");
  EXPECT_EQ(wrapped("", 6, 2), "\n");
  EXPECT_EQ(wrapped("    abcdefghij", 8, 4), "    abcd\n    efgh\n    ij\n")
      << "never breaks before a first word";
}

TEST(Text, APositionIsNotBrokenOverLines) {
  EXPECT_EQ(wrapped("far (lat 39 10.498 N, lon 73 49.821 W)", 20, 2),
            "far (lat\n  39 10.498 N, lon\n  73 49.821 W)\n");
  for (size_t columns = 28; columns < 60; ++columns) {
    for (const std::string position :
         {"39 10.5 N 73 49.8 W", "39.175 N 73.83 W", "3910.5 N 7349.8 W", "10.5 S 7 0.25 E",
          "73 49.8 W", "0 0 N"}) {
      const std::string text =
          wrapped("steers to the waypoint " + position + ", 5 N of it", columns, 2);
      EXPECT_NE(text.find(position), std::string::npos) << columns << ": " << text;
    }
  }
  EXPECT_EQ(wrapped("one 12 34 two", 8, 2), "one 12\n  34 two\n")
      << "two numbers are not a position";
  EXPECT_EQ(wrapped("39 10.5 N 73 49.8 W", 8, 2), "39 10.5 \n  N 73 4\n  9.8 W\n")
      << "no line is too long";
}

TEST(Text, ClockShowsHoursOnlyWhenThereAreSome) {
  EXPECT_EQ(clockText(0), "0:00");
  EXPECT_EQ(clockText(59.6), "1:00");
  EXPECT_EQ(clockText(2500), "41:40");
  EXPECT_EQ(clockText(3 * 3600 + 125), "3:02:05");
}

}  // namespace
}  // namespace glider::report
