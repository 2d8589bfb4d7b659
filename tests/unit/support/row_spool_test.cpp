// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Rows of a trace that wait on disk.

#include "support/trace/row_spool.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace glider::support {
namespace {

constexpr size_t kWide = 3;

Trace empty() {
  Trace trace;
  trace.columns = {{"time", "s"}, {"a", ""}, {"b", ""}};
  return trace;
}

void addRow(Trace& trace, size_t row) {
  const auto number = static_cast<double>(row);
  trace.rows.insert(trace.rows.end(),
                    {number, -number / 3,
                     row % 2 == 0 ? std::numeric_limits<double>::quiet_NaN() : number * 1e-300});
}

TEST(RowSpool, GivesBackEachRowAsItWas) {
  for (const size_t rows : {size_t{0}, size_t{1}, RowSpool::kMostRows - 1, RowSpool::kMostRows,
                            RowSpool::kMostRows + 1, size_t{5000}}) {
    Trace spooled = empty(), plain = empty();
    RowSpool spool;
    size_t most = 0;
    for (size_t row = 0; row < rows; ++row) {
      addRow(spooled, row);
      addRow(plain, row);
      spool.take(spooled);
      most = std::max(most, spooled.rowCount());
      ASSERT_GE(spooled.rowCount(), 1U);
      EXPECT_EQ(spooled.rows[spooled.rows.size() - kWide], static_cast<double>(row))
          << "the newest stays";
    }
    EXPECT_LE(most, RowSpool::kMostRows);
    spool.giveBack(spooled);
    EXPECT_EQ(traceToCsv(spooled), traceToCsv(plain)) << rows;
    spool.giveBack(spooled);
    EXPECT_EQ(spooled.rows.size(), plain.rows.size()) << "once";
  }
}

/// The newest row is completed after it was recorded.
TEST(RowSpool, TheNewestRowMayChange) {
  Trace trace = empty();
  RowSpool spool;
  for (size_t row = 0; row < 2000; ++row) {
    addRow(trace, row);
    spool.take(trace);
    trace.rows[trace.rows.size() - 2] = 77;
  }
  spool.giveBack(trace);
  ASSERT_EQ(trace.rowCount(), 2000U);
  for (size_t row = 0; row < 2000; ++row) {
    EXPECT_EQ(trace.at(row, 1), 77) << row;
  }
}

}  // namespace
}  // namespace glider::support
