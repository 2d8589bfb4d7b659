// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/flights/flight.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace glider::tests {
namespace {

/// Splits one CSV line; fields may be quoted, with "" for a quote.
std::vector<std::string> splitCsv(const std::string& line) {
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (c == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"') {
      fields.back() += '"';
      ++i;
    } else if (c == '"') {
      quoted = !quoted;
    } else if (c == ',' && !quoted) {
      fields.emplace_back();
    } else {
      fields.back() += c;
    }
  }
  return fields;
}

double number(const std::string& text) {
  return text.empty() ? NAN : std::stod(text);
}

void readTrace(Flight& flight) {
  std::istringstream lines(flight.csv);
  std::string line;
  std::getline(lines, line);
  for (const std::string& title : splitCsv(line)) {
    flight.columns.push_back(title.substr(0, title.find(' ')));
  }
  while (std::getline(lines, line)) {
    std::vector<double> row;
    for (const std::string& field : splitCsv(line)) {
      row.push_back(number(field));
    }
    flight.rows.push_back(std::move(row));
  }
}

void readEvents(Flight& flight, const std::string& csv) {
  std::istringstream lines(csv);
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line)) {
    const auto f = splitCsv(line);
    ASSERT_EQ(f.size(), 5U) << line;
    flight.events.push_back({number(f[0]), number(f[1]), f[2], f[3], f[4]});
  }
}

}  // namespace

std::vector<Event> Flight::transitions() const {
  std::vector<Event> found;
  std::ranges::copy_if(events, std::back_inserter(found),
                       [](const Event& e) { return e.kind == "transition"; });
  return found;
}

double Flight::valueAt(const std::string& name, double time_s) const {
  const auto times = column("time");
  const auto values = column(name);
  double value = std::numeric_limits<double>::quiet_NaN();
  for (size_t i = 0; i < times.size() && times[i] <= time_s; ++i) {
    value = values[i];
  }
  return value;
}

std::vector<double> Flight::column(const std::string& name) const {
  const auto at = std::ranges::find(columns, name) - columns.begin();
  std::vector<double> values;
  if (at == static_cast<ptrdiff_t>(columns.size())) {
    ADD_FAILURE() << "the trace has no column " << name;
    return values;
  }
  for (const auto& row : rows) {
    values.push_back(row.at(static_cast<size_t>(at)));
  }
  return values;
}

Flight fly(const std::string& arguments) {
  const TemporaryFolder folder;
  const std::string output = (folder.path() / "flight").string();
  Flight flight;
  flight.outcome = runShell("$GLIDERCC sim " + arguments + " -o " + output);
  flight.csv = slurp(output + "/trace.csv");
  readTrace(flight);
  readEvents(flight, slurp(output + "/events.csv"));
  return flight;
}

std::string project(const std::string& path) {
  return std::string(GLIDER_SOURCE_DIR) + "/" + path;
}

}  // namespace glider::tests
