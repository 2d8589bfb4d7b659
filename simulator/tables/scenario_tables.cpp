// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/tables/scenario_tables.h"

#include <fmt/format.h>

#include <numbers>

namespace glider::simulator {
namespace {

const toml::table& emptyTable() {
  static const toml::table kEmpty;
  return kEmpty;
}

}  // namespace

void Fields::number(const char* key, double& into, double lowest, double highest) {
  into = reader_.numberOr(key, into);
  if (has(key) && !(into >= lowest && into <= highest) && !reader_.failure()) {
    reader_.refuse(key, fmt::format("must be between {} and {}", lowest, highest));
  }
}

double Fields::required(const char* key, double lowest, double highest) {
  double value = reader_.number(key);
  number(key, value, lowest, highest);
  return value;
}

double Fields::anyNumber(const char* key) {
  const std::optional<double> value = table_[key].value<double>();
  if (!value) {
    reader_.refuse(key, "must be a number");
  }
  return value.value_or(0);
}

void Fields::bearing(const char* key, double& into) {
  constexpr double kRadPerDegree = std::numbers::pi / 180;
  if (has(key)) {
    into = required(key, 0, 360) * kRadPerDegree;
  }
}

void Fields::place(double& x, double& y) {
  const double latitude = required("latitude_deg", -89, 89);
  const double longitude = required("longitude_deg", -180, 180);
  if (frame_ != nullptr && !reader_.failure()) {
    frame_->locate({latitude, longitude}, x, y);
  }
}

void Fields::together(const char* one, const char* other) {
  if (has(one) != has(other)) {
    const char* given = has(one) ? one : other;
    reader_.refuse(given, fmt::format("needs `{}` as well", has(one) ? other : one));
  }
}

void ScenarioTables::read(const toml::table& table, const std::string& where, const Read& read) {
  Fields fields(file_, table, where, frame_ ? &*frame_ : nullptr);
  read(fields);
  if (!failure_ && fields.reader().failure()) {
    failure_ = fields.reader().failure();
  }
}

void ScenarioTables::refuse(const char* table, const char* part, const char* why) {
  this->table(table, [&](Fields& fields) { fields.reader().refuse(part, why); });
}

void ScenarioTables::head(const Read& read) {
  this->read(root_, "the scenario", read);
}

void ScenarioTables::table(const char* table, const Read& read) {
  const toml::table* found = root_[table].as_table();
  this->read(found != nullptr ? *found : emptyTable(), fmt::format("[{}]", table), read);
}

void ScenarioTables::part(const char* table, const char* part, const Read& read) {
  const auto at = root_[table][part];
  if (at && !at.is_table()) {
    refuse(table, part, "must be a table");
    return;
  }
  this->read(at ? *at.as_table() : emptyTable(), fmt::format("[{}.{}]", table, part), read);
}

void ScenarioTables::each(const char* table, const char* part, const Read& read) {
  const auto at = root_[table][part];
  if (!at) {
    return;
  }
  constexpr size_t kMost = 1000;
  const toml::array* list = at.as_array();
  if (list == nullptr || list->size() > kMost ||
      !(list->empty() || list->is_homogeneous<toml::table>())) {
    const std::string why = fmt::format("must be at most {} [[{}.{}]] tables", kMost, table, part);
    refuse(table, part, why.c_str());
    return;
  }
  for (const toml::node& node : *list) {
    this->read(*node.as_table(), fmt::format("[[{}.{}]]", table, part), read);
  }
}

}  // namespace glider::simulator
