// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "support/csv.h"
#include "support/one_line.h"

#include <gtest/gtest.h>

namespace glider::support {
namespace {

TEST(Texts, OnOneLine) {
  EXPECT_EQ(onOneLine("a\n  b\t\tc"), "a b c");
  EXPECT_EQ(onOneLine("  a"), "a");
  EXPECT_EQ(onOneLine("a\r\nb "), "a b ");
  EXPECT_EQ(onOneLine(""), "");
}

TEST(Texts, CsvQuoted) {
  EXPECT_EQ(csvQuoted(""), "\"\"");
  EXPECT_EQ(csvQuoted("a \"b\", c"), "\"a \"\"b\"\", c\"");
}

}  // namespace
}  // namespace glider::support
