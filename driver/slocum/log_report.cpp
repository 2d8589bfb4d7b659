// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/slocum/log_report.h"

#include "driver/output/track_colour.h"
#include "report/beside.h"
#include "report/picture/picture.h"
#include "report/report.h"
#include "report/warnings.h"
#include "support/files.h"
#include "vehicles/slocum/data_tables/merge.h"
#include "vehicles/slocum/data_traces/flight_trace.h"

namespace glider::driver {
namespace {

using support::Result;
using support::Trace;

/// The log with the simulated flight of `path` beside it. The rows of both flights are rows of it:
/// where the log has few, the simulated one keeps its inflections.
Result<Trace> traceBeside(const slocum::Merged& merged, const Trace& alone,
                          const std::string& path) {
  const auto text = support::readFile(path);
  if (!text) {
    return std::unexpected(text.error());
  }
  const auto flight = support::traceFromCsv(*text, path);
  if (!flight) {
    return std::unexpected(flight.error());
  }
  const auto shift = report::shiftBeside(alone, *flight, path);
  if (!shift) {
    return std::unexpected(shift.error());
  }
  std::vector<double> times;
  for (size_t row = 0; row < flight->rowCount(); ++row) {
    times.push_back(alone.log->utc_s + *shift + flight->at(row, 0));
  }
  auto both = slocum::flightTrace(merged, times);
  if (both) {
    report::addBeside(*both, *flight, *shift, path);
  }
  return both;
}

}  // namespace

Result<void> drawLog(const std::vector<slocum::LogFile>& files, const DataLogOptions& options) {
  const slocum::Merged merged = slocum::merge(files, slocum::flightTraceSensors());
  auto trace = slocum::flightTrace(merged);
  if (trace && !options.beside.empty()) {
    trace = traceBeside(merged, *trace, options.beside);
  }
  if (!trace) {
    return std::unexpected(trace.error());
  }
  if (!options.report.empty()) {
    support::DiagnosticEngine diagnostics;
    report::reportFlight(*trace, diagnostics);
    if (auto written = report::writeReport(*trace, options.report, diagnostics.sorted());
        !written) {
      return written;
    }
  }
  return options.picture.empty()
             ? Result<void>()
             : support::writeFileAtomically(
                   options.picture,
                   report::drawPicture(*trace, styleFor(*trace, options.picture_style)));
}

}  // namespace glider::driver
