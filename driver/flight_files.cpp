// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/flight_files.h"

#include "driver/csv.h"
#include "report/report.h"
#include "support/files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace glider::driver {
namespace {

/// A quoted field that is one line.
std::string textCell(std::string text) {
  std::ranges::replace_if(text, [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return csvQuoted(text);
}

std::string numberCell(double value) {
  return std::isnan(value) ? "" : fmt::format("{}", value);
}

}  // namespace

std::string eventsToCsv(const support::Trace& trace) {
  std::string out = "time (s),missiontime (s),kind,what,why\n";
  for (const support::TraceEvent& event : trace.events) {
    out +=
        fmt::format("{},{},{},{},{}\n", numberCell(event.time_s), numberCell(event.mission_time_s),
                    textCell(event.kind), textCell(event.what), textCell(event.why));
  }
  return out;
}

support::Result<void> makeFolder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) {
    return support::fail(support::DiagnosticId::cannotWrite, folder.string(), error.message());
  }
  return {};
}

support::Result<void> writeFlight(const support::Trace& trace,
                                  const std::filesystem::path& folder) {
  if (auto made = makeFolder(folder); !made) {
    return made;
  }
  if (auto written = support::writeFileAtomically(folder / "trace.csv", support::traceToCsv(trace));
      !written) {
    return written;
  }
  if (auto written = support::writeFileAtomically(folder / "events.csv", eventsToCsv(trace));
      !written) {
    return written;
  }
  return report::writeReport(trace, folder / "report.html");
}

}  // namespace glider::driver
