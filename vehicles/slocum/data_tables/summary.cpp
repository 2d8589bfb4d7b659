// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/data_tables/summary.h"

#include "support/counted.h"
#include "support/utc.h"
#include "vehicles/slocum/data_files/header.h"
#include "vehicles/slocum/data_tables/merge.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace glider::slocum {
namespace {

/// What a column holds.
struct Figures {
  uint64_t updates = 0;
  double min = NAN;
  double max = NAN;
  double last = NAN;

  void take(double value) {
    ++updates;
    last = value;
    if (!std::isnan(value)) {
      min = std::isnan(min) ? value : std::min(min, value);
      max = std::isnan(max) ? value : std::max(max, value);
    }
  }
};

using support::utcText;

std::string_view word(Computer computer) {
  return computer == Computer::Flight ? "flight" : "science";
}

/// One line for each file, its columns aligned.
std::string filesText(const std::vector<LogFile>& files) {
  size_t name = 0, mission = 0;
  for (const LogFile& file : files) {
    name = std::max(name, file.path.filename().string().size());
    mission = std::max(mission, file.data.header.mission.size());
  }
  std::string text;
  for (const LogFile& file : files) {
    const auto [begin, end] = file.span();
    const double opened = timeOf(file.data.header.opened).value_or(NAN);
    fmt::format_to(
        std::back_inserter(text), "  {:{}}  {:7}  {:{}}  segment {}, {} to {}, {}\n",
        file.path.filename().string(), name, word(file.data.computer), file.data.header.mission,
        mission, file.data.header.full_name, utcText(std::isnan(begin) ? opened : begin),
        utcText(std::isnan(end) ? opened : end), support::counted(file.data.records, "record"));
  }
  return text;
}

/// A value with the digits that a float32 has, or to the millisecond for the time of a record.
std::string readable(double value, uint8_t width) {
  return std::isnan(value) ? "-" : fmt::format("{:.{}g}", value, width == 4 ? 7 : 13);
}

/// A row of the table of sensors.
using Cells = std::vector<std::string>;

/// Lines of aligned columns: the first two to the left, the others to the right.
std::string aligned(const std::vector<Cells>& rows) {
  std::vector<size_t> width(rows[0].size());
  for (const Cells& row : rows) {
    for (size_t i = 0; i < row.size(); ++i) {
      width[i] = std::max(width[i], row[i].size());
    }
  }
  std::string text;
  for (const Cells& row : rows) {
    for (size_t i = 0; i < row.size(); ++i) {
      text += i < 2 ? fmt::format("  {:<{}}", row[i], width[i])
                    : fmt::format("  {:>{}}", row[i], width[i]);
    }
    text += '\n';
  }
  return text;
}

std::string sensorsText(const std::vector<LogFile>& files,
                        const std::vector<std::string>& patterns) {
  const Merged merged = merge(files, patterns);
  std::vector<Cells> rows = {{"sensor", "unit", "updates", "min", "max", "last"}};
  size_t never = 0;
  for (size_t column = 0; column < merged.columns.size(); ++column) {
    Figures figures;
    merged.forEachUpdateOf(column, [&](uint32_t, double value) { figures.take(value); });
    const std::string& name = merged.columns[column].name;
    const Sensor& sensor = merged.columns[column].sensor;
    if (figures.updates == 0) {
      if (std::ranges::find(patterns, name) == patterns.end()) {
        ++never;
        continue;
      }
      figures.last = initialValue(merged, column);
    }
    const auto text = [&](double value) { return readable(value, sensor.width); };
    rows.push_back({name, sensor.unit, std::to_string(figures.updates), text(figures.min),
                    text(figures.max), text(figures.last)});
  }
  std::string text = "\n" + aligned(rows);
  if (never > 0) {
    text += never == 1 ? "  and 1 sensor that was never updated\n"
                       : fmt::format("  and {} sensors that were never updated\n", never);
  }
  return text;
}

}  // namespace

std::string summaryOf(const std::vector<LogFile>& files, const std::vector<std::string>& patterns) {
  const std::string count = files.size() == 1 ? "1 file" : fmt::format("{} files", files.size());
  return fmt::format("{}: {}, times in UTC\n", files[0].vehicle, count) + filesText(files) +
         sensorsText(files, patterns);
}

}  // namespace glider::slocum
