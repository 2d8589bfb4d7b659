// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "support/diagnostics/ids/flights.h"
#include "support/trace/trace.h"

#include <fmt/format.h>

#include <charconv>
#include <limits>
#include <optional>
#include <string_view>

namespace glider::support {
namespace {

/// Removes the first line of `text` and returns it without its end.
std::string_view takeLine(std::string_view& text) {
  const size_t end = text.find('\n');
  std::string_view line = text.substr(0, end);
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  if (line.ends_with('\r')) {
    line.remove_suffix(1);
  }
  return line;
}

/// Calls `take(cell)` for each cell of a line.
template <typename Take>
void forEachCell(std::string_view line, Take take) {
  for (size_t comma = line.find(','); comma != std::string_view::npos; comma = line.find(',')) {
    take(line.substr(0, comma));
    line.remove_prefix(comma + 1);
  }
  take(line);
}

/// The column of "m_depth (m)".
TraceColumn columnOf(std::string_view head) {
  const size_t open = head.find(" (");
  if (open == std::string_view::npos || !head.ends_with(')')) {
    return {std::string(head), ""};
  }
  return {std::string(head.substr(0, open)),
          std::string(head.substr(open + 2, head.size() - open - 3))};
}

/// NaN for an empty cell.
std::optional<double> numberOf(std::string_view cell) {
  double value = std::numeric_limits<double>::quiet_NaN();
  if (cell.empty()) {
    return value;
  }
  const auto [rest, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  return error == std::errc() && rest == cell.data() + cell.size() ? std::optional(value)
                                                                   : std::nullopt;
}

/// Appends the cells of a line to the rows; false if they do not fit the columns.
bool addRow(std::string_view line, Trace& trace) {
  const size_t before = trace.rows.size();
  bool valid = true;
  forEachCell(line, [&](std::string_view cell) {
    const std::optional<double> value = numberOf(cell);
    valid = valid && value.has_value();
    trace.rows.push_back(value.value_or(0));
  });
  return valid && trace.rows.size() - before == trace.columns.size();
}

}  // namespace

Result<Trace> traceFromCsv(const std::string& text, const std::string& name) {
  std::string_view rest = text;
  Trace trace;
  forEachCell(takeLine(rest),
              [&](std::string_view cell) { trace.columns.push_back(columnOf(cell)); });
  if (trace.columns[0].name != "time") {
    return fail(support::diagnostics::notFlightTrace, name, "its first column is not `time (s)`");
  }
  if (trace.column("m_depth") < 0 && trace.column("true_depth") < 0) {
    return fail(support::diagnostics::notFlightTrace, name,
                "it has no column `m_depth` or `true_depth`");
  }
  for (size_t number = 2; !rest.empty(); ++number) {
    if (!addRow(takeLine(rest), trace)) {
      return fail(support::diagnostics::notFlightTrace, name,
                  fmt::format("line {} does not have a number or nothing for each of {} columns",
                              number, trace.columns.size()));
    }
  }
  return trace;
}

}  // namespace glider::support
