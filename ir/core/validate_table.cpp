// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/core/validate_table.h"

#include <cmath>

namespace glider::ir {
namespace {

constexpr size_t kMostRows = 4096;

bool isClock(Op op) {
  return op == Op::MissionTime || op == Op::StateTime || op == Op::ResumeTime;
}

bool sound(const GuardColumn& column, const Mission& mission) {
  const bool source = column.source == Op::Sensor
                          ? column.sensor.index < mission.sensors.size()
                          : isClock(column.source) && !column.sensor.valid();
  bool in_order = true;
  for (size_t i = 0; i < column.cuts.size(); ++i) {
    const Cut& cut = column.cuts[i];
    in_order = in_order && std::isfinite(cut.at);
    if (i > 0) {
      const Cut& before = column.cuts[i - 1];
      in_order = in_order && (before.at < cut.at ||
                              (before.at == cut.at && before.inclusive && !cut.inclusive));
    }
  }
  return source && in_order;
}

bool sound(const GuardRow& row, const GuardTable& table, size_t case_count) {
  bool fits = row.number < case_count && row.within.size() == table.columns.size();
  for (size_t i = 0; fits && i < row.within.size(); ++i) {
    const GuardRow::Range& range = row.within[i];
    fits = range.first <= range.last && range.last <= table.columns[i].unknown();
  }
  return fits;
}

}  // namespace

std::string defectOf(const GuardTable& table, const Mission& mission, size_t case_count) {
  if (table.empty()) {
    return table.rows.empty() ? "" : "rows without columns";
  }
  if (table.rows.size() > kMostRows || case_count > kMostRows) {
    return "more rows or cases than it can number";
  }
  for (const GuardColumn& column : table.columns) {
    if (!sound(column, mission)) {
      return "a column that is not a sensor or clock, or whose cuts are not in order";
    }
  }
  for (size_t i = 0; i < table.rows.size(); ++i) {
    if (!sound(table.rows[i], table, case_count)) {
      return "a row without a case, or with intervals that its columns do not have";
    }
    if (i > 0 && table.rows[i].number < table.rows[i - 1].number) {
      return "rows that are not in the order of the cases";
    }
  }
  return {};
}

}  // namespace glider::ir
