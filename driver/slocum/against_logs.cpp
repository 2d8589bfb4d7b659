// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/slocum/against_logs.h"

#include "analysis/against/against_logs.h"
#include "analysis/check/check.h"
#include "driver/exit_code.h"
#include "driver/terminal.h"
#include "flights/launch_choice.h"
#include "report/against_marks.h"
#include "report/picture/against_picture.h"
#include "report/report.h"
#include "support/diagnostics/ids/command.h"
#include "support/files.h"
#include "vehicles/slocum/data_tables/merge.h"
#include "vehicles/slocum/data_traces/flight_trace.h"

#include <algorithm>
#include <utility>

namespace glider::driver {
namespace {

/// The report page of the vehicle's logs, with what the mission would have done.
support::Result<void> writePage(const std::vector<slocum::LogFile>& files,
                                const analysis::CheckedFile& checked, const std::string& path) {
  auto flight = slocum::flightTrace(slocum::merge(files, slocum::flightTraceSensors()));
  if (!flight) {
    return std::unexpected(flight.error());
  }
  report::markAgainst(checked.compilation->checked->mission().name, checked.found.against[0],
                      *flight);
  return report::writeReport(*flight, path);
}

}  // namespace

VehicleLogs readVehicleLogs(const AgainstOptions& options) {
  slocum::SensorLists lists({options.caches.begin(), options.caches.end()});
  slocum::LogFiles logs = slocum::readLogFiles({options.logs.begin(), options.logs.end()}, lists);
  for (const std::string& why : logs.skipped) {
    tell("glidercc: note: " + why + "\n");
  }
  std::ranges::for_each(logs.warnings, reportWarning);
  VehicleLogs out;
  for (const support::Failure& failure : logs.failures) {
    out.status = reportFailure(failure);
  }
  out.vehicles = slocum::byVehicle(std::move(logs.files));
  return out;
}

void runAgainst(const VehicleLogs& logs, const AgainstOptions& options,
                analysis::CheckedFile& checked) {
  if (logs.vehicles.empty() || !checked.found.ok() || !checked.compilation ||
      !checked.compilation->checked) {
    return;
  }
  const auto parameters =
      flights::chooseParameters(checked.compilation->checked->mission(), options.launch);
  if (!parameters) {
    checked.found.failure = parameters.error();
    return;
  }
  for (const auto& files : logs.vehicles) {
    auto against = analysis::runAgainstLogs(*checked.compilation->checked, files, *parameters);
    if (!against) {
      checked.found.failure = against.error();
      return;
    }
    checked.found.against.push_back(std::move(*against));
  }
}

support::Result<void> drawAgainst(const VehicleLogs& logs, const AgainstOptions& options,
                                  const analysis::CheckedFile& checked) {
  const auto& all = checked.found.against;
  if ((options.picture.empty() && options.page.empty()) || all.empty()) {
    return {};
  }
  if (all.size() > 1) {
    std::string names;
    for (const report::AgainstLogs& one : all) {
      names += (names.empty() ? "`" : ", `") + one.vehicle + "`";
    }
    return support::fail(support::diagnostics::severalVehicles, names);
  }
  if (!options.page.empty()) {
    if (auto written = writePage(logs.vehicles[0], checked, options.page); !written) {
      return written;
    }
  }
  return options.picture.empty()
             ? support::Result<void>()
             : support::writeFileAtomically(
                   options.picture,
                   report::drawAgainst(all[0], *checked.found.sources, options.picture_style));
}

}  // namespace glider::driver
