// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/output/flight_files.h"

#include "driver/output/flight_folder.h"
#include "report/facts_json.h"
#include "report/figures.h"
#include "report/report.h"
#include "report/warnings.h"
#include "support/csv.h"
#include "support/diagnostics/ids/files.h"
#include "support/files.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace glider::driver {
namespace {

/// A quoted field on one line.
std::string textCell(std::string text) {
  std::ranges::replace_if(text, [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return support::csvQuoted(text);
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
                    textCell(kindOf(event)), textCell(textOf(event)), textCell(event.why));
  }
  return out;
}

support::Result<void> makeFolder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) {
    return support::fail(support::diagnostics::cannotWrite, folder.string(), error.message());
  }
  return {};
}

support::Result<void> writeFlight(const support::Trace& trace, const std::filesystem::path& folder,
                                  const std::vector<support::Diagnostic>& reported) {
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
  return report::writeReport(trace, folder / "report.html", reported);
}

std::string flightToJson(const support::Trace& trace,
                         const std::vector<support::Diagnostic>& reported,
                         std::vector<std::string> files) {
  using nlohmann::ordered_json;
  files.emplace_back(FlightFolder::kSummary);
  const ordered_json document = {
      {"mission", trace.mission},
      {"scenario", trace.scenario},
      {"way", trace.way},
      {"seed", trace.seed},
      {"wentWell", reported.empty()},
      {"warnings",
       ordered_json::parse(report::warningsToJson(reported, report::flightNotes(trace)))},
      {"requirements", ordered_json::parse(report::promisesToJson(trace.facts))},
      {"figures", ordered_json::parse(report::figuresToJson(report::flightFigures(trace)))},
      {"files", files}};
  return document.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

support::Result<void> writeFlightSummary(const support::Trace& trace,
                                         const std::vector<support::Diagnostic>& reported,
                                         std::vector<std::string> files,
                                         const std::filesystem::path& folder) {
  return support::writeFileAtomically(folder / FlightFolder::kSummary,
                                      flightToJson(trace, reported, std::move(files)));
}

}  // namespace glider::driver
