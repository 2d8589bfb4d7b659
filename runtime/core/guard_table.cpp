// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/abi/order.h"
#include "runtime/core/readings.h"

namespace glider::runtime {
namespace {

// The answer as it is remembered: memory that is zero remembers none.
constexpr uint32_t kNotAsked = 0;
constexpr uint32_t kAnswerBias = 2;  // GLIDER_NO_CASE becomes 1

/// How many of the column's thresholds lie at or below `order`.
uint32_t search(const GliderGuardColumn& column, int64_t order) {
  uint32_t first = 0;
  uint32_t end = column.key_count;
  while (first < end) {  // halves each round
    const uint32_t middle = first + (end - first) / 2;
    if (column.keys[middle] <= order) {
      first = middle + 1;
    } else {
      end = middle;
    }
  }
  return first;
}

/// Brings `interval` up to date; true if it was not.
bool move(const GliderContext& context, const GliderGuardColumn& column, uint32_t& interval) {
  const int64_t order = gliderOrder(valueOf(context, column.source, column.sensor));
  const bool inside = (interval == 0 || column.keys[interval - 1] <= order) &&
                      (interval == column.key_count || order < column.keys[interval]);
  if (!inside) {
    interval = search(column, order);
  }
  return !inside;
}

/// The rows, of those that stand in word `word`, that hold in every column.
uint32_t rowsIn(const GliderGuardTable& table, const uint32_t* intervals, uint32_t word) {
  uint32_t rows = UINT32_MAX;
  for (uint32_t i = 0; i < table.column_count; ++i) {
    rows &= table.columns[i].rows[intervals[i] * table.words + word];
  }
  return rows;
}

uint32_t firstTrue(const GliderContext& context, const GliderGuardTable& table,
                   const uint32_t* intervals, uint32_t from) {
  for (uint32_t word = 0; word < table.words; ++word) {
    // Every round takes one bit away.
    for (uint32_t rows = rowsIn(table, intervals, word); rows != 0; rows &= rows - 1) {
      const uint32_t row = 32 * word + static_cast<uint32_t>(__builtin_ctz(rows));
      const uint32_t number = table.cases[row];
      const bool exact = (table.exact[word] & rows & (~rows + 1)) != 0;
      if (number >= from && (exact || table.holds(&context, number) != 0)) {
        return number;
      }
    }
  }
  return GLIDER_NO_CASE;
}

}  // namespace
}  // namespace glider::runtime

extern "C" uint32_t gliderFirstTrue(GliderContext* context, const GliderGuardTable* table,
                                    uint32_t from) {
  using namespace glider::runtime;
  uint32_t& answer = context->intervals[table->memory];
  uint32_t* intervals = &context->intervals[table->memory + 1];
  bool moved = false;
  for (uint32_t i = 0; i < table->column_count; ++i) {
    moved = move(*context, table->columns[i], intervals[i]) || moved;
  }
  const bool remembers = from == 0 && table->holds == nullptr;
  if (remembers && !moved && answer != kNotAsked) {
    return answer - kAnswerBias;
  }
  const uint32_t found = firstTrue(*context, *table, intervals, from);
  answer = remembers ? found + kAnswerBias : kNotAsked;
  return found;
}
