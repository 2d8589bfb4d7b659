// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What gliderFirstTrue finds in a table, from the constants of the table: GliderGuardTable of
// runtime/abi/abi_structs.def. What it keeps from tick to tick only saves work.

#include "codegen/llvm/validate/run.h"
#include "codegen/llvm/validate/tables.h"
#include "codegen/llvm/validate/undecided.h"
#include "runtime/abi/glider_abi.h"
#include "runtime/abi/order.h"

#include <llvm/IR/Constants.h>

#include <utility>

namespace glider::codegen::validate {
namespace {

constexpr uint32_t kWordBits = 32;

/// What a pointer in a constant points at.
const llvm::Constant& listOf(const llvm::Constant* pointer) {
  const llvm::Constant* list = behind(pointer);
  if (list == nullptr) {
    throw Undecided("a table of guards that is not a constant");
  }
  return *list;
}

/// Lists of zeros alone have another form.
uint64_t elementOf(const llvm::Constant& list, uint64_t number) {
  const llvm::Constant* element = list.getAggregateElement(static_cast<unsigned>(number));
  if (element == nullptr) {
    throw Undecided("a table of guards that ends too early");
  }
  return llvm::cast<llvm::ConstantInt>(element)->getZExtValue();
}

/// Rows that may hold in each interval of a column, and the keys between the intervals.
class Column {
 public:
  Column(const llvm::Constant& column, uint64_t words) {
    namespace field = field::GliderGuardColumn;
    const llvm::Constant& listed = listOf(fieldOf(column, field::keys));
    const llvm::Constant& rows = listOf(fieldOf(column, field::rows));
    const uint64_t count = wordOf(column, field::key_count);
    for (uint64_t i = 0; i < count; ++i) {
      keys.push_back(static_cast<int64_t>(elementOf(listed, i)));
    }
    std::vector<uint64_t> here;
    for (uint64_t interval = 0; interval <= count; ++interval) {
      const bool last = interval == count;
      if (last || interval % GLIDER_GUARD_STRIDE == 0) {
        const uint64_t stride =
            last ? (count - 1) / GLIDER_GUARD_STRIDE + 1 : interval / GLIDER_GUARD_STRIDE;
        here.clear();
        for (uint64_t word = 0; word < words; ++word) {
          here.push_back(elementOf(rows, stride * words + word));
        }
      } else {
        turn(column, interval - 1, here);
      }
      may_hold.push_back(here);
    }
  }

  [[nodiscard]] bool mayHold(uint64_t interval, uint64_t row) const {
    return (may_hold[interval][row / kWordBits] >> row % kWordBits & 1U) != 0;
  }

  std::vector<int64_t> keys;
  std::vector<std::vector<uint64_t>> may_hold;

 private:
  /// The rows that change at that threshold.
  static void turn(const llvm::Constant& column, uint64_t threshold, std::vector<uint64_t>& rows) {
    namespace field = field::GliderGuardColumn;
    const llvm::Constant& first = listOf(fieldOf(column, field::first_turn));
    const uint64_t end = elementOf(first, threshold + 1);
    for (uint64_t i = elementOf(first, threshold); i < end; ++i) {
      const uint64_t row = elementOf(listOf(fieldOf(column, field::turns)), i);
      rows.at(row / kWordBits) ^= uint64_t{1} << row % kWordBits;
    }
  }
};

/// The number that a column is about.
z3::expr sourceOf(Effects& effects, const Memory& memory, const llvm::Constant& column) {
  namespace context = field::GliderContext;
  Places& places = effects.places();
  const auto read = [&](Address at) { return effects.load(memory, at); };
  const auto since = [&](unsigned then) {
    Numbers& numbers = effects.numbers();
    return numbers.settle(
        numbers.subtract(read(places.context(context::mission_time)), read(places.context(then))));
  };
  switch (static_cast<GliderSource>(wordOf(column, field::GliderGuardColumn::source))) {
    case kGliderSensor: {
      const uint64_t sensor = wordOf(column, field::GliderGuardColumn::sensor);
      return read(places.reading({static_cast<uint32_t>(sensor)}, field::GliderReading::value));
    }
    case kGliderMissionTime:
      return read(places.context(context::mission_time));
    case kGliderStateTime:
      return since(context::entered);
    case kGliderResumeTime:
      return since(context::resumed);
  }
  throw Undecided("a column of a table of guards that is about nothing");
}

/// Whether the number of that order is in an interval in which the row may hold.
z3::expr mayHold(const Column& column, uint64_t row, const z3::expr& order) {
  z3::context& z3 = order.ctx();
  const auto key = [&](uint64_t i) { return z3.bv_val(column.keys[i], 64); };
  z3::expr holds = z3.bool_val(false);
  const uint64_t count = column.keys.size();
  for (uint64_t from = 0; from <= count; ++from) {
    if (!column.mayHold(from, row)) {
      continue;
    }
    uint64_t to = from;
    while (to < count && column.mayHold(to + 1, row)) {
      ++to;
    }
    z3::expr inside = z3.bool_val(true);
    if (from > 0) {
      inside = inside && key(from - 1) <= order;
    }
    if (to < count) {
      inside = inside && order < key(to);
    }
    holds = holds || inside;
    from = to;
  }
  return holds.simplify();
}

}  // namespace

z3::expr Run::callTable(const llvm::CallInst& call) {
  namespace field = field::GliderGuardTable;
  enum : unsigned { Context, TableOf, From };
  const llvm::Constant& table = listOf(llvm::dyn_cast<llvm::Constant>(call.getArgOperand(TableOf)));
  const z3::expr from = value(call.getArgOperand(From));
  const uint64_t words = wordOf(table, field::words);
  std::vector<std::pair<Column, z3::expr>> columns;
  for (uint64_t i = 0; i < wordOf(table, field::column_count); ++i) {
    const llvm::Constant& column =
        *listOf(fieldOf(table, field::columns)).getAggregateElement(static_cast<unsigned>(i));
    const z3::expr bits = numbers().canonical(sourceOf(effects(), memory_, column));
    const z3::expr order =
        z3::ite(bits < z3().bv_val(0, 64), bits ^ z3().bv_val(INT64_MAX, 64), bits);
    columns.emplace_back(Column(column, words), order);
  }
  const llvm::Constant& cases = listOf(fieldOf(table, field::cases));
  const uint64_t rows = llvm::cast<llvm::ArrayType>(cases.getType())->getNumElements();
  const auto* holds = llvm::dyn_cast<llvm::Function>(fieldOf(table, field::holds));
  z3::expr found = effects().word(GLIDER_NO_CASE);
  for (uint64_t row = rows; row-- > 0;) {
    const uint64_t number = elementOf(cases, row);
    z3::expr is_true = z3::ule(from, effects().word(static_cast<uint32_t>(number)));
    for (const auto& [column, order] : columns) {
      is_true = is_true && mayHold(column, row, order);
    }
    const uint64_t exact = elementOf(listOf(fieldOf(table, field::exact)), row / kWordBits);
    if ((exact >> row % kWordBits & 1U) == 0) {
      if (holds == nullptr) {
        throw Undecided("a table of guards without the guards that it needs");
      }
      const std::vector<z3::expr> arguments{value(call.getArgOperand(Context)),
                                            effects().word(static_cast<uint32_t>(number))};
      is_true = is_true && code_.run(*holds, arguments, memory_).result != effects().word(0);
    }
    found = z3::ite(is_true, effects().word(static_cast<uint32_t>(number)), found).simplify();
  }
  return found;
}

}  // namespace glider::codegen::validate
