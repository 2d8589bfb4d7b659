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

TEST(Text, ClockShowsHoursOnlyWhenThereAreSome) {
  EXPECT_EQ(clockText(0), "0:00");
  EXPECT_EQ(clockText(59.6), "1:00");
  EXPECT_EQ(clockText(2500), "41:40");
  EXPECT_EQ(clockText(3 * 3600 + 125), "3:02:05");
}

}  // namespace
}  // namespace glider::report
