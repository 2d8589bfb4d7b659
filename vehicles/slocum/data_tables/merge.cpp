// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/data_tables/merge.h"

#include "vehicles/slocum/data_tables/log_units.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace glider::slocum {
namespace {

char lowerCase(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
}

std::string lowerCase(std::string_view text) {
  std::string out(text);
  std::ranges::transform(out, out.begin(), [](char c) { return lowerCase(c); });
  return out;
}

/// The order of names of sensors, in which case does not matter.
struct ByName {
  bool operator()(const std::string& a, const std::string& b) const {
    const auto lower = [](char c) { return lowerCase(c); };
    return std::ranges::lexicographical_compare(a, b, {}, lower, lower);
  }
};

/// The units of one sensor of one computer, in the order of the files.
using Units = std::vector<Sensor>;
using Sensors = std::map<std::string, std::map<Computer, Units>, ByName>;

/// The name of a column in a table of both computers. The owner's sensor keeps its name: science
/// owns those that begin with `sci_`, flight all others.
std::string mergedName(const std::string& name, Computer computer, bool in_both) {
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
      if (!files[i].isLeftOut(record)) {
        rows.push_back({files[i].times[record], i, record});
      }
    }
  }
  // Records without a time come first; those of one time stay in the order of the files.
  std::ranges::stable_sort(rows, [](const MergedRow& a, const MergedRow& b) {
    return std::isnan(a.time) ? !std::isnan(b.time) : a.time < b.time;
  });
  return rows;
}

/// "_in_dbar", also for a unit with signs that a name cannot have.
std::string unitEnding(const std::string& unit) {
  std::string ending = "_in_";
  for (const char c : unit) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    ending += plain ? c : '_';
  }
  return ending;
}

Sensors sensorsOf(std::span<const LogFile> files) {
  Sensors sensors;
  for (const LogFile& file : files) {
    for (const Column& column : file.data.columns) {
      Units& units = sensors[column.sensor.name][file.data.computer];
      const auto is_same = [&](const Sensor& known) {
        return plainUnit(known.unit) == plainUnit(column.sensor.unit);
      };
      if (std::ranges::none_of(units, is_same)) {
        units.push_back(column.sensor);
      }
    }
  }
  return sensors;
}

/// The columns of one file by name.
class FileColumns {
 public:
  explicit FileColumns(const LogFile& file) : file_(file) {
    for (size_t i = 0; i < file.data.columns.size(); ++i) {
      at_.try_emplace(file.data.columns[i].sensor.name, i);
    }
  }
  /// The column that belongs to `column`; kNone if there is none.
  [[nodiscard]] size_t find(const MergedColumn& column) const {
    const auto found = at_.find(column.sensor.name);
    const bool here =
        file_.data.computer == column.computer && found != at_.end() &&
        plainUnit(file_.data.columns[found->second].sensor.unit) == plainUnit(column.sensor.unit);
    return here ? found->second : Merged::kNone;
  }

 private:
  const LogFile& file_;
  std::map<std::string, size_t, ByName> at_;
};

}  // namespace

bool matches(std::string_view given_name, std::string_view given_pattern) {
  const std::string lower_name = lowerCase(given_name), lower_pattern = lowerCase(given_pattern);
  std::string_view name = lower_name, pattern = lower_pattern;
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

std::vector<MergedColumn> columnsOf(std::span<const LogFile> files) {
  std::vector<MergedColumn> columns;
  for (const auto& [name, computers] : sensorsOf(files)) {
    for (const auto& [computer, units] : computers) {
      const std::string merged = mergedName(name, computer, computers.size() > 1);
      for (size_t i = 0; i < units.size(); ++i) {
        columns.push_back(
            {i == 0 ? merged : merged + unitEnding(units[i].unit), units[i], computer, i > 0});
      }
    }
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
    const FileColumns here(file);
    auto& in_file = merged.in_file.emplace_back();
    for (const MergedColumn& column : merged.columns) {
      in_file.push_back(here.find(column));
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
