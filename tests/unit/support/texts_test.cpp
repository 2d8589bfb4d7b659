// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "support/csv.h"
#include "support/grouped.h"
#include "support/one_line.h"
#include "support/units/duration_text.h"
#include "support/utc.h"

#include <gtest/gtest.h>

#include <cmath>

namespace glider::support {
namespace {

TEST(Texts, OnOneLine) {
  EXPECT_EQ(onOneLine("a\n  b\t\tc"), "a b c");
  EXPECT_EQ(onOneLine("  a"), "a");
  EXPECT_EQ(onOneLine("a\r\nb "), "a b ");
  EXPECT_EQ(onOneLine(""), "");
  EXPECT_EQ(onOneLine("a # b\nc // d\r\ne /* f\n g */ h"), "a c e h");
  EXPECT_EQ(onOneLine("a / b /* open"), "a / b ");
  EXPECT_EQ(onOneLine("log \"# // /* no */\" # yes"), "log \"# // /* no */\" ");
  EXPECT_EQ(onOneLine("a\x1b[2Jb"), "a?[2Jb");
}

TEST(Texts, Printable) {
  EXPECT_EQ(printable("a\tb\nc\x1b\x7f\xc3\xa9"), "a b?c??\xc3\xa9");
}

TEST(Texts, CsvQuoted) {
  EXPECT_EQ(csvQuoted(""), "\"\"");
  EXPECT_EQ(csvQuoted("a \"b\", c"), "\"a \"\"b\"\", c\"");
}

TEST(Texts, ABoundIsRoundedToItsOwnSide) {
  EXPECT_EQ(atMost(66.93), "67");
  EXPECT_EQ(atLeast(66.99), "66.9");
  EXPECT_EQ(atMost(0.12341), "0.124");
  EXPECT_EQ(atLeast(0.12349), "0.123");
  EXPECT_EQ(atMost(9.87), "9.87") << "it is that to the last digit of a double";
  EXPECT_EQ(atLeast(9.87), "9.87");
  EXPECT_EQ(atMost(99.91), "100");
  EXPECT_EQ(atMost(100.07), "101");
  EXPECT_EQ(atLeast(100.97), "100");
  EXPECT_EQ(atMost(1249.5), "1,250");
  EXPECT_EQ(atLeast(0), "0");
}

TEST(UtcText, IsOfAnyCalendarDay) {
  EXPECT_EQ(utcText(1709251199.9), "2024-02-29 23:59:59");
  EXPECT_EQ(utcText(0), "1970-01-01 00:00:00");
  EXPECT_EQ(utcText(-1), "1969-12-31 23:59:59");
  EXPECT_EQ(utcText(1e300), "unknown");
  EXPECT_EQ(utcText(NAN), "unknown");
  EXPECT_EQ(instantText(1250000180), "2009-08-11T14:16:20Z");
  EXPECT_EQ(instantText(NAN), "unknown");
}

TEST(DurationText, IsAsPeopleSayIt) {
  EXPECT_EQ(durationText(0), "0 s");
  EXPECT_EQ(durationText(41.25), "41.25 s");
  EXPECT_EQ(durationText(59.7), "1 min");
  EXPECT_EQ(durationText(12600), "3 h 30 min");
  EXPECT_EQ(durationText(54808.1), "15 h 13 min 28 s");
  EXPECT_EQ(durationText(-3600), "-1 h");
  EXPECT_EQ(durationText(86400), "1 day");
  EXPECT_EQ(durationText(3.1536e7), "365 days");
  EXPECT_EQ(durationText(1e300), "1e+300 s");
  EXPECT_EQ(durationText(INFINITY), "inf s");
}

TEST(DurationText, IsAnArgumentInTheLongestUnitThatHasItWhole) {
  EXPECT_EQ(durationArgument(172800), "2days");
  EXPECT_EQ(durationArgument(86400), "1day");
  EXPECT_EQ(durationArgument(72000), "20h");
  EXPECT_EQ(durationArgument(74400), "1240min");
  EXPECT_EQ(durationArgument(90), "90s");
  EXPECT_EQ(durationArgument(0), "0s");
}

}  // namespace
}  // namespace glider::support
