// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/replay_trace.h"

#include "analysis/replay.h"
#include "driver/compile_for_flight.h"
#include "driver/exit_code.h"
#include "driver/output/flight_folder.h"
#include "driver/terminal.h"
#include "flights/launch_choice.h"
#include "flights/sbc_choice.h"
#include "support/counted.h"
#include "support/files.h"
#include "support/trace/trace.h"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace glider::driver {
namespace {

/// Reports the result of a replay.
int tellReplay(const support::Trace& trace, const analysis::Replayed& replayed,
               const std::string& way) {
  std::string text;
  for (const support::TraceEvent& event : trace.events) {
    if (isOfKind(event, support::EventKind::Transition)) {
      text += textOf(event) + "\n";
    }
  }
  const std::string ticks = support::counted(replayed.ticks, "tick");
  text += replayed.broken
              ? fmt::format(
                    "at {:.6g} s the mission violates `{}`: {} followed the counterexample, "
                    "tick by tick ({})\n",
                    replayed.when, trace.scenario, way, ticks)
              : fmt::format("`{}` holds in this flight ({}, {})\n", trace.scenario, ticks, way);
  const auto printed = printOut(text);
  if (!printed) {
    return reportFailure(printed.error());
  }
  return replayed.broken ? kMissionHasErrors : kFine;
}

/// A mission built for this process, with the parameters of the trace.
struct Loaded {
  std::shared_ptr<const codegen::LoadedMission> mission;
  std::vector<double> parameters;
};

support::Result<Loaded> load(const compiler::Optimised& mission, const SimOptions& options) {
  auto loaded = flights::loadHere(mission, options.user_code);
  if (!loaded) {
    return std::unexpected(loaded.error());
  }
  auto parameters = flights::chooseParameters(mission.mission, options.launch);
  if (!parameters) {
    return std::unexpected(parameters.error());
  }
  return Loaded{std::make_shared<const codegen::LoadedMission>(std::move(*loaded)),
                std::move(*parameters)};
}

/// Replays the trace on the SBC that `options` choose.
int replay(const support::Trace& trace, const compiler::Optimised& mission,
           const SimOptions& options) {
  auto loaded = load(mission, options);
  if (!loaded) {
    return reportFailure(loaded.error());
  }
  // A board's binary is built and its log written here; a replay leaves no files.
  const auto folder = FlightFolder::scratch();
  if (!folder) {
    return reportFailure(folder.error());
  }
  const auto start = isInProcess(options)
                         ? flights::startInProcess(loaded->mission, loaded->parameters, false)
                         : chooseSbc(options, &mission, false, folder->staging(), nullptr);
  if (!start) {
    return reportFailure(start.error());
  }
  const auto sbc = (*start)();
  if (!sbc) {
    return reportFailure(sbc.error());
  }
  const auto replayed = analysis::replayRun(
      trace, *mission.checked, compiler::stateNames(mission.mission), loaded->parameters, **sbc);
  if (!replayed) {
    return reportFailure(replayed.error());
  }
  return tellReplay(trace, *replayed, (*sbc)->way());
}

}  // namespace

int replayTrace(SimOptions options) {
  // The folder that check wrote is as good as the file in it.
  if (std::error_code ignored; std::filesystem::is_directory(options.replay, ignored)) {
    options.replay = (std::filesystem::path(options.replay) / FlightFolder::kRun).string();
  }
  const auto text = support::readFile(options.replay);
  if (!text) {
    return reportFailure(text.error());
  }
  const auto trace = support::traceFromJson(*text, options.replay);
  if (!trace) {
    return reportFailure(trace.error());
  }
  int status = kFine;
  const auto mission = compileForFlight(options.mission, status);
  if (status != kFine) {
    return status;
  }
  if (auto fits = analysis::checkTrace(*trace, options.replay, *mission->checked); !fits) {
    return reportFailure(fits.error());
  }
  options.launch.settings = trace->settings;
  return replay(*trace, *mission, options);
}

}  // namespace glider::driver
