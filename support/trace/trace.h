// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/result.h"
#include "support/trace/events.h"
#include "support/trace/flight_facts.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace glider::support {

/// One quantity recorded at every flight-control cycle. NaN is "not known".
struct TraceColumn {
  std::string name;  ///< "m_depth", "true_x", "state"…; the vehicle's own name if it has one
  std::string
      unit;  ///< as in the language; "" for a plain number, "id" for an index into Trace::names
};

/// The value of the column "hook_vertical" while a hover is in force.
inline constexpr double kHoverCommanded = 3;

/// The water's temperature on a grid along the flight, the background of the picture.
struct TraceField {
  std::string unit = "degC";
  std::vector<double> times_s;
  std::vector<double> depths_m;
  std::vector<double> values;  ///< times × depths, depth fastest
};

/// A stretch of time in which a log has no records.
struct TraceGap {
  double from_s = 0;  ///< the last row before it
  double to_s = 0;    ///< the first row after it
};

/// What only a flight that a real vehicle has logged has.
struct VehicleLog {
  std::string vehicle;              ///< its name
  double utc_s = 0;                 ///< UTC of time 0 by the vehicle's clock, s since 1970
  std::string beside;               ///< the simulated flight that is drawn beside it; "": none
  std::vector<std::string> notes;   ///< what the reader must know, one sentence each
  std::vector<TraceGap> gaps = {};  ///< by time; nothing is known of the vehicle in them
};

/// What a `log` statement of the mission wrote, whole: the vehicle receives only the begin of it.
struct LoggedNote {
  double mission_time_s = 0;
  std::string text;            ///< of the statement
  std::vector<double> values;  ///< SI units or degrees; NaN: unknown
};

/// One flight: the only trace format of verifier, simulator and report.
struct Trace {
  std::string mission;   ///< name of the mission
  std::string scenario;  ///< name of the scenario; for a counterexample, the requirement that it
                         ///< violates, as written
  std::string way;       ///< "in-process", "host", "ts7800", "ts5500", "none" (no SBC)
  uint64_t seed = 0;
  std::string own_control = "layered control";  ///< what flies while the SBC is not in control
  std::vector<std::string> state_names;         ///< for the column "state"
  /// The parameters of a counterexample, in the form that `--set` takes; each "name=value".
  std::vector<std::string> settings;
  std::optional<uint32_t> requirement;  ///< which one a counterexample violates, from 0
  std::vector<TraceColumn> columns;     ///< columns[0] is "time" in s
  std::vector<double> rows;             ///< row-major, columns.size() values per row
  std::vector<TraceEvent> events;       ///< in order of time
  TraceField field;
  std::optional<VehicleLog> log;  ///< empty for a simulated flight or a counterexample
  // Of a simulated flight.
  MissionFacts facts;                      ///< empty if no mission of the language flies
  std::optional<BatteryFacts> battery;     ///< empty: not known
  std::optional<AcousticTotals> acoustic;  ///< empty: no modem was in use
  std::vector<LoggedNote> notes;           ///< in order; empty: not known
  BottomGrid bottom;                       ///< empty if the bottom is flat
  double start_utc_s = 0;                  ///< the vehicle's clock at time 0, s since 1970

  [[nodiscard]] size_t rowCount() const {
    return columns.empty() ? 0 : rows.size() / columns.size();
  }
  /// The number of column `name`; -1 if there is none.
  [[nodiscard]] int column(std::string_view name) const;
  [[nodiscard]] double at(size_t row, int column) const {
    return rows[row * columns.size() + static_cast<size_t>(column)];
  }
  /// Whether the time from `from_s` to `to_s`, of two rows that follow each other, is within a gap
  /// of the log.
  [[nodiscard]] bool isGap(double from_s, double to_s) const;
};

/// The rows as CSV: a header `name (unit)`, shortest round-trip decimals, an empty cell for NaN.
/// Byte-identical for identical rows.
std::string traceToCsv(const Trace& trace);
/// The whole trace as one JSON object (NaN is null): what the report page reads.
std::string traceToJson(const Trace& trace);
/// Reads what traceToJson writes, except for the field and the log; `name` is for messages. GL9360
/// if it is not such a trace.
Result<Trace> traceFromJson(const std::string& text, const std::string& name);
/// Reads the rows and columns that traceToCsv writes; `name` is for messages. GL9366 if it is not
/// such a table, or has no depth.
Result<Trace> traceFromCsv(const std::string& text, const std::string& name);

}  // namespace glider::support
