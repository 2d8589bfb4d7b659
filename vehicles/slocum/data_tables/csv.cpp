// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/data_tables/csv.h"

#include "support/csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace glider::slocum {
namespace {

struct Cell {
  uint32_t column = 0;
  double value = 0;
};

/// The updates of all rows, row after row; within a row by column.
struct CellsByRow {
  std::vector<size_t> begin;  ///< of each row, and the end of the last
  std::vector<Cell> cells;
};

CellsByRow cellsByRow(const Merged& merged) {
  CellsByRow out;
  out.begin.assign(merged.rows.size() + 1, 0);
  for (size_t column = 0; column < merged.columns.size(); ++column) {
    merged.forEachUpdateOf(column, [&](uint32_t row, double) { ++out.begin[row + 1]; });
  }
  for (size_t row = 1; row < out.begin.size(); ++row) {
    out.begin[row] += out.begin[row - 1];
  }
  out.cells.resize(out.begin.back());
  std::vector<size_t> next = out.begin;
  for (uint32_t column = 0; column < merged.columns.size(); ++column) {
    merged.forEachUpdateOf(
        column, [&](uint32_t row, double value) { out.cells[next[row]++] = {column, value}; });
  }
  return out;
}

/// A name that needs no quotes stays as it is.
std::string field(const std::string& name) {
  return name.find_first_of(",\"") == std::string::npos ? name : support::csvQuoted(name);
}

}  // namespace

std::string csvOf(const Merged& merged) {
  const CellsByRow cells = cellsByRow(merged);
  std::string text = "time_s,computer";
  for (const MergedColumn& column : merged.columns) {
    text += "," + field(column.name);
  }
  text += '\n';
  for (size_t row = 0; row < merged.rows.size(); ++row) {
    const MergedRow& source = merged.rows[row];
    if (!std::isnan(source.time)) {
      fmt::format_to(std::back_inserter(text), "{}", source.time);
    }
    text += merged.files[source.file].data.computer == Computer::Flight ? ",flight" : ",science";
    size_t commas = 0;
    for (size_t i = cells.begin[row]; i < cells.begin[row + 1]; ++i) {
      const auto& [column, value] = cells.cells[i];
      text.append(column + 1 - commas, ',');
      commas = column + 1;
      text += valueText(value, merged.columns[column].sensor.width);
    }
    text.append(merged.columns.size() - commas, ',');
    text += '\n';
  }
  return text;
}

}  // namespace glider::slocum
