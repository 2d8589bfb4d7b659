// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/core/ops.h"
#include "ir/core/walk.h"
#include "ir/opt/dnf.h"
#include "ir/opt/passes.h"

#include <algorithm>
#include <map>

namespace glider::ir::opt {
namespace {

/// With fewer comparisons a table costs as much as the comparisons.
constexpr size_t kFewestComparisons = 16;
/// The compiled mission numbers rows with 16 bits.
constexpr size_t kMostTableRows = 4096;

GuardColumn makeColumn(const Watched& watched, const std::vector<Conjunction>& rows) {
  GuardColumn column{watched.source, watched.sensor, {}};
  for (const Conjunction& row : rows) {
    if (const auto found = row.bounds.find(watched); found != row.bounds.end()) {
      for (const std::optional<Cut>& cut : {found->second.above, found->second.below}) {
        if (cut) {
          column.cuts.push_back(*cut);
        }
      }
    }
  }
  auto before = [](const Cut& a, const Cut& b) {
    return a.at != b.at ? a.at < b.at : a.inclusive && !b.inclusive;
  };
  std::ranges::sort(column.cuts, before);
  column.cuts.erase(std::unique(column.cuts.begin(), column.cuts.end()), column.cuts.end());
  return column;
}

/// How many cuts lie below the interval that begins at `cut`.
uint32_t placeOf(const GuardColumn& column, const Cut& cut) {
  return static_cast<uint32_t>(std::ranges::find(column.cuts, cut) - column.cuts.begin());
}

GuardRow::Range rangeOf(const GuardColumn& column, const Bounds& bounds) {
  if (bounds.unknown) {
    return {column.unknown(), column.unknown()};
  }
  return {bounds.above ? placeOf(column, *bounds.above) + 1 : 0,
          bounds.below ? placeOf(column, *bounds.below) : column.unknown() - 1};
}

GuardTable makeTable(const std::vector<Conjunction>& rows) {
  std::map<Watched, uint32_t> numbers;
  GuardTable table;
  for (const Conjunction& row : rows) {
    for (const auto& [watched, bounds] : row.bounds) {
      if (numbers.emplace(watched, static_cast<uint32_t>(table.columns.size())).second) {
        table.columns.push_back(makeColumn(watched, rows));
      }
    }
  }
  for (const Conjunction& conjunction : rows) {
    GuardRow& row = table.rows.emplace_back();
    row.number = conjunction.number;
    row.exact = conjunction.exact;
    for (const GuardColumn& column : table.columns) {
      row.within.push_back({0, column.unknown()});
    }
    for (const auto& [watched, bounds] : conjunction.bounds) {
      const uint32_t column = numbers.at(watched);
      row.within[column] = rangeOf(table.columns[column], bounds);
    }
  }
  return table;
}

/// A table skips guards, but a guard with C functions must call them on each tick, in the mission's
/// order.
bool callsC(const Mission& mission, ExprId guard) {
  return anyIn(mission, guard, [](const Expr& e) { return e.op == Op::Call; });
}

GuardTable tabulate(const Mission& mission, const std::vector<Case>& cases) {
  if (!mission.uses.empty() &&
      std::ranges::any_of(cases, [&](const Case& c) { return callsC(mission, c.guard); })) {
    return {};
  }
  std::vector<Conjunction> rows;
  size_t comparisons = 0;
  for (uint32_t i = 0; i < cases.size(); ++i) {
    for (Conjunction& row : disjunctionOf(mission, cases[i].guard)) {
      row.number = i;
      comparisons += row.bounds.size();
      rows.push_back(std::move(row));
    }
  }
  const bool worth_it = comparisons >= kFewestComparisons && rows.size() <= kMostTableRows &&
                        cases.size() <= kMostTableRows;
  return worth_it ? makeTable(rows) : GuardTable{};
}

}  // namespace

void tabulateGuards(Mission& mission) {
  mission.always_table = tabulate(mission, mission.always);
  for (State& state : mission.states) {
    state.table = tabulate(mission, state.cases);
  }
}

}  // namespace glider::ir::opt
