// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/replay_trace.h"

#include "analysis/replay.h"
#include "driver/compile_for_flight.h"
#include "driver/exit_code.h"
#include "driver/flight_folder.h"
#include "driver/terminal.h"
#include "flights/flight_setup.h"
#include "support/files.h"
#include "support/trace/trace.h"

#include <fmt/format.h>

#include <string>

namespace glider::driver {
namespace {

/// What a replay came to.
int tellReplay(const support::Trace& trace, const analysis::Replayed& replayed,
               const std::string& way) {
  std::string text;
  for (const support::TraceEvent& event : trace.events) {
    if (event.kind == "transition") {
      text += event.what + "\n";
    }
  }
  text += replayed.broken
              ? fmt::format(
                    "at {:.6g} s the mission violates `{}`: {} followed the counterexample, "
                    "tick by tick ({} ticks)\n",
                    replayed.when, trace.scenario, way, replayed.ticks)
              : fmt::format("`{}` holds in this flight ({} ticks, {})\n", trace.scenario,
                            replayed.ticks, way);
  const auto printed = printOut(text);
  if (!printed) {
    return reportFailure(printed.error());
  }
  return replayed.broken ? kMissionHasErrors : kFine;
}

}  // namespace

int replayTrace(SimOptions options) {
  const auto text = support::readFile(options.replay);
  if (!text) {
    return reportFailure(text.error());
  }
  const auto trace = support::traceFromJson(*text, options.replay);
  if (!trace) {
    return reportFailure(trace.error());
  }
  const auto mission = compiler::compileMission(options.mission);
  if (!mission) {
    return reportFailure(mission.error());
  }
  int status = kFine;
  const auto built = compileForFlight(options.mission, status);
  if (status != kFine) {
    return status;
  }
  if (auto fits = analysis::checkTrace(*trace, options.replay, **mission); !fits) {
    return reportFailure(fits.error());
  }
  options.launch.settings = trace->settings;
  const auto loaded = flights::loadHere(*built, options.user_code);
  const auto parameters =
      loaded ? flights::chooseParameters(loaded->mission(), options.launch)
             : support::Result<std::vector<double>>(std::unexpected(loaded.error()));
  if (!parameters) {
    return reportFailure(parameters.error());
  }
  // Where a board's binary is built and its log written; a replay leaves nothing behind.
  const auto folder = FlightFolder::scratch();
  if (!folder) {
    return reportFailure(folder.error());
  }
  const auto start = chooseSbc(options, built.get(), false, folder->staging());
  if (!start) {
    return reportFailure(start.error());
  }
  const auto sbc = (*start)();
  if (!sbc) {
    return reportFailure(sbc.error());
  }
  const auto replayed = analysis::replayRun(
      *trace, **mission, compiler::stateNames(*built->mission), *parameters, **sbc);
  if (!replayed) {
    return reportFailure(replayed.error());
  }
  return tellReplay(*trace, *replayed, (*sbc)->way());
}

}  // namespace glider::driver
