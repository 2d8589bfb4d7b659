// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "slocum/data_tables/merge.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace glider::slocum {
namespace {

using Key = std::pair<std::string, Computer>;

/// The name of a column in a table of both computers. The owner's sensor keeps its name: science
/// owns those that begin with `sci_`, flight all others.
std::string mergedName(const Key& key, bool in_both) {
  const auto& [name, computer] = key;
  const Computer owner = name.starts_with("sci_") ? Computer::Science : Computer::Flight;
  if (!in_both || computer == owner) {
    return name;
  }
  return (computer == Computer::Flight ? "gld_dup_" : "sci_dup_") + name;
}

std::vector<MergedRow> rowsOf(const std::vector<LogFile>& files) {
  std::vector<MergedRow> rows;
  for (uint32_t i = 0; i < files.size(); ++i) {
    for (uint32_t record = files[i].first; record < files[i].data.records; ++record) {
      rows.push_back({files[i].times[record], i, record});
    }
  }
  // Records without a time come first; those of one time stay in the order of the files.
  std::ranges::stable_sort(rows, [](const MergedRow& a, const MergedRow& b) {
    return std::isnan(a.time) ? !std::isnan(b.time) : a.time < b.time;
  });
  return rows;
}

}  // namespace

bool matches(std::string_view name, std::string_view pattern) {
  const size_t star = pattern.find('*');
  if (star == std::string_view::npos) {
    return name == pattern;
  }
  if (!name.starts_with(pattern.substr(0, star))) {
    return false;
  }
  name.remove_prefix(star);
  pattern.remove_prefix(star);
  // Each part between stars is taken where it first fits, the last one at the end.
  while (!pattern.empty()) {
    pattern.remove_prefix(1);
    const size_t next = std::min(pattern.find('*'), pattern.size());
    const std::string_view part = pattern.substr(0, next);
    if (next == pattern.size()) {
      return name.ends_with(part);
    }
    const size_t found = name.find(part);
    if (found == std::string_view::npos) {
      return false;
    }
    name.remove_prefix(found + part.size());
    pattern.remove_prefix(next);
  }
  return true;
}

std::vector<MergedColumn> columnsOf(const std::vector<LogFile>& files) {
  std::map<Key, Sensor> sensors;
  for (const LogFile& file : files) {
    for (const Column& column : file.data.columns) {
      sensors.try_emplace({column.sensor.name, file.data.computer}, column.sensor);
    }
  }
  std::vector<MergedColumn> columns;
  for (const auto& [key, sensor] : sensors) {
    const Computer other = key.second == Computer::Flight ? Computer::Science : Computer::Flight;
    columns.push_back({mergedName(key, sensors.contains({key.first, other})), sensor, key.second});
  }
  std::ranges::sort(columns, {}, &MergedColumn::name);
  return columns;
}

Merged merge(const std::vector<LogFile>& files, const std::vector<std::string>& patterns) {
  Merged merged{files, columnsOf(files), rowsOf(files), {}, {}};
  std::erase_if(merged.columns, [&](const MergedColumn& column) {
    return !patterns.empty() && std::ranges::none_of(patterns, [&](const std::string& pattern) {
      return matches(column.name, pattern);
    });
  });
  for (const LogFile& file : files) {
    merged.row_of.emplace_back(file.data.records - file.first);
    std::map<std::string_view, size_t> at;
    for (size_t i = 0; i < file.data.columns.size(); ++i) {
      at.try_emplace(file.data.columns[i].sensor.name, i);
    }
    auto& in_file = merged.in_file.emplace_back();
    for (const MergedColumn& column : merged.columns) {
      const auto found = at.find(column.sensor.name);
      const bool here = column.computer == file.data.computer && found != at.end();
      in_file.push_back(here ? found->second : Merged::kNone);
    }
  }
  for (uint32_t row = 0; row < merged.rows.size(); ++row) {
    const MergedRow& source = merged.rows[row];
    merged.row_of[source.file][source.record - files[source.file].first] = row;
  }
  return merged;
}

double initialValue(const Merged& merged, size_t column) {
  for (size_t i = 0; i < merged.files.size(); ++i) {
    const size_t at = merged.in_file[i][column];
    if (at != Merged::kNone && merged.files[i].first > 0) {
      return merged.files[i].data.columns[at].values[0];
    }
  }
  return NAN;
}

std::string valueText(double value, uint8_t width) {
  if (std::isnan(value)) {
    return "nan";
  }
  return width == 4 ? fmt::format("{}", static_cast<float>(value)) : fmt::format("{}", value);
}

}  // namespace glider::slocum
