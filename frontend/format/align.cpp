// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/format/align.h"

#include "frontend/format/layout.h"

#include <algorithm>
#include <span>

namespace glider::frontend::formatting {
namespace {

size_t cellColumn(const Row& row, size_t cell) {
  return width(std::string_view(row.text).substr(0, row.cells[cell]));
}

/// Rows of one shape with no blank line between them.
void alignCells(std::span<Row> rows) {
  std::vector<Row> padded(rows.begin(), rows.end());
  for (size_t cell = 0; cell < rows[0].cells.size(); ++cell) {
    size_t column = 0;
    for (const Row& row : padded) {
      column = std::max(column, cellColumn(row, cell));
    }
    for (Row& row : padded) {
      const size_t blanks = column - cellColumn(row, cell);
      row.text.insert(row.cells[cell], blanks, ' ');
      for (size_t later = cell; later < row.cells.size(); ++later) {
        row.cells[later] += blanks;
      }
    }
  }
  if (std::ranges::all_of(padded, [](const Row& row) { return width(row.text) <= kColumns; })) {
    std::ranges::move(padded, rows.begin());
  }
}

/// Rows that all have a remark.
void alignRemarks(std::span<Row> rows) {
  constexpr size_t kGap = 2;
  size_t column = 0;
  for (const Row& row : rows) {
    column = std::max(column, width(row.text));
  }
  const bool fits = std::ranges::all_of(
      rows, [column](const Row& row) { return column + kGap + width(row.remark) <= kColumns; });
  for (Row& row : rows) {
    row.text.append(fits ? column - width(row.text) + kGap : kGap, ' ');
    row.text += row.remark;
  }
}

/// Calls `work` with each longest run of rows without blank lines in which every row is `like` the
/// first.
template <typename Like, typename Work>
void forRuns(std::vector<Row>& rows, Like like, Work work) {
  for (size_t first = 0; first < rows.size();) {
    size_t end = first + 1;
    while (end < rows.size() && !rows[end].blank_before && like(rows[first], rows[end])) {
      ++end;
    }
    work(std::span(rows).subspan(first, end - first));
    first = end;
  }
}

}  // namespace

void align(std::vector<Row>& rows) {
  forRuns(
      rows, [](const Row& a, const Row& b) { return !a.shape.empty() && a.shape == b.shape; },
      alignCells);
  forRuns(
      rows, [](const Row& a, const Row& b) { return a.remark.empty() == b.remark.empty(); },
      [](std::span<Row> run) {
        if (!run[0].remark.empty()) {
          alignRemarks(run);
        }
      });
}

}  // namespace glider::frontend::formatting
