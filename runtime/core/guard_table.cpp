// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/abi/order.h"
#include "runtime/core/assert.h"
#include "runtime/core/readings.h"

namespace glider::runtime {
namespace {

// Values of the first word of a table's memory. Memory of zeros holds nothing.
constexpr uint32_t kNothing = 0;
constexpr uint32_t kNoAnswer = 1;    // only the columns are known
constexpr uint32_t kAnswerBias = 3;  // GLIDER_NO_CASE becomes 2

/// The number of the column's thresholds at or below `order`.
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

/// The memory of a column: its interval, then the rows that may hold there.
class Column {
 public:
  Column(const GliderGuardColumn& column, uint32_t* memory, uint32_t words)
      : column_(column), interval_(memory[0]), rows_(memory + 1), words_(words) {}

  /// Brings it up to date; true if it has changed.
  bool refresh(int64_t order, bool remembered) {
    const bool inside = remembered && (interval_ == 0 || column_.keys[interval_ - 1] <= order) &&
                        (interval_ == column_.key_count || order < column_.keys[interval_]);
    if (!inside) {
      interval_ = search(column_, order);
      gatherRows();
    }
    return !inside;
  }

 private:
  void gatherRows() {
    const bool last = interval_ == column_.key_count;
    const uint32_t stride =
        last ? (column_.key_count - 1) / GLIDER_GUARD_STRIDE + 1 : interval_ / GLIDER_GUARD_STRIDE;
    for (uint32_t word = 0; word < words_; ++word) {
      rows_[word] = column_.rows[stride * words_ + word];
    }
    const uint32_t from = last ? interval_ : stride * GLIDER_GUARD_STRIDE;
    const uint32_t end = column_.first_turn[interval_];
    for (uint32_t turn = column_.first_turn[from]; turn < end; ++turn) {
      const uint32_t row = column_.turns[turn];
      rows_[row / 32] ^= 1U << (row % 32);
    }
  }

  const GliderGuardColumn& column_;
  uint32_t& interval_;
  uint32_t* rows_;
  uint32_t words_;
};

/// True if a number has left its interval.
bool refresh(const GliderContext& context, const GliderGuardTable& table, uint32_t* memory,
             bool remembered) {
  bool moved = false;
  for (uint32_t i = 0; i < table.column_count; ++i) {
    const GliderGuardColumn& column = table.columns[i];
    uint32_t* own = memory + i * (1 + table.words);
    if (!GLIDER_ASSERT(context, !remembered || own[0] <= column.key_count, GuardInterval)) {
      return true;
    }
    const int64_t order = gliderOrder(valueOf(context, column.source, column.sensor));
    const bool left = Column(column, own, table.words).refresh(order, remembered);
    moved = moved || left;
  }
  return moved;
}

uint32_t firstTrueRow(const GliderContext& context, const GliderGuardTable& table,
                      const uint32_t* memory, uint32_t from) {
  for (uint32_t word = 0; word < table.words; ++word) {
    uint32_t rows = UINT32_MAX;
    for (uint32_t i = 0; i < table.column_count; ++i) {
      rows &= memory[i * (1 + table.words) + 1 + word];
    }
    for (; rows != 0; rows &= rows - 1) {  // every round clears one bit
      const auto bit = static_cast<uint32_t>(__builtin_ctz(rows));
      const uint32_t number = table.cases[32 * word + bit];
      const bool exact = (table.exact[word] >> bit & 1U) != 0;
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
  if (!GLIDER_ASSERT(*context,
                     table->memory + gliderGuardMemory(table->column_count, table->words) <=
                         context->mission->interval_count,
                     GuardMemory)) {
    return GLIDER_NO_CASE;
  }
  uint32_t& answer = context->intervals[table->memory];
  uint32_t* columns = &context->intervals[table->memory + 1];
  const bool moved = refresh(*context, *table, columns, answer != kNothing);
  const bool remembers = from == 0 && table->holds == nullptr;
  if (remembers && !moved && answer > kNoAnswer) {
    return answer - kAnswerBias;
  }
  const uint32_t found = firstTrueRow(*context, *table, columns, from);
  answer = remembers ? found + kAnswerBias : kNoAnswer;
  return found;
}
