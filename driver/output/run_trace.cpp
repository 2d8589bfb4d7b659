// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/output/run_trace.h"

#include "analysis/check/check.h"
#include "analysis/trace_of_run.h"
#include "driver/output/flight_files.h"
#include "driver/output/flight_folder.h"
#include "support/files.h"

#include <fmt/format.h>

#include <string>

namespace glider::driver {
namespace {

/// Writes all files of a trace, which then replace those of an earlier one.
support::Result<void> writeRun(const support::Trace& trace, const std::filesystem::path& place) {
  auto folder = FlightFolder::open(place, FlightFolder::Use::Run);
  if (!folder) {
    return std::unexpected(folder.error());
  }
  if (auto written = writeFlight(trace, folder->staging()); !written) {
    return written;
  }
  const auto written = support::writeFileAtomically(folder->staging() / FlightFolder::kRun,
                                                    support::traceToJson(trace));
  return written ? folder->commit() : written;
}

}  // namespace

support::Result<std::vector<std::filesystem::path>> writeRuns(const analysis::CheckedFile& checked,
                                                              const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> places;
  for (const ir::prove::RequirementVerdict& verdict : checked.proved.requirements) {
    if (verdict.verdict != ir::prove::Verdict::Refuted || !verdict.run) {
      continue;
    }
    const auto place = folder / fmt::format("requirement-{}", verdict.requirement + 1);
    if (auto written =
            writeRun(analysis::traceOfRun(*checked.compilation->checked, verdict), place);
        !written) {
      return std::unexpected(written.error());
    }
    places.push_back(place);
  }
  return places;
}

}  // namespace glider::driver
