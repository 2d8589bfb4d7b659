// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "analysis/trial_flight.h"

#include "analysis/heard_flight.h"
#include "flights/flight_setup.h"
#include "flights/launch_choice.h"
#include "flights/requirement_watch.h"
#include "flights/sbc_choice.h"
#include "report/warnings.h"
#include "simulator/simulator.h"
#include "support/diagnostics/ids/verification.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>

namespace glider::analysis {
namespace {

/// Reports that a behaviour above hookbeh replaced its commands, unless the mission file has
/// already said it.
void reportMasked(const support::Trace& trace, const std::string& hint,
                  support::DiagnosticEngine& diagnostics) {
  const auto masked =
      std::ranges::find(trace.events, support::EventId::CommandsMasked, &support::TraceEvent::id);
  if (masked != trace.events.end()) {
    diagnostics.report(support::diagnostics::commandsMasked, {},
                       fmt::format("at {:.0f} s of a flight another behaviour replaced {}",
                                   masked->time_s, std::get<std::string>(masked->values.at(0))),
                       hint);
  }
}

bool saysMasked(const support::DiagnosticEngine& diagnostics) {
  const auto all = diagnostics.sorted();
  return std::ranges::any_of(all, [](const support::Diagnostic& one) {
    return one.id == support::diagnostics::commandsMasked;
  });
}

}  // namespace

support::Result<void> reportTrialFlight(const compiler::Optimised& mission,
                                        const simulator::Scenario& scenario,
                                        const std::vector<std::string>& user_code,
                                        const std::string& hint,
                                        support::DiagnosticEngine& diagnostics) {
  const bool lacks_code = flights::needsCodeInC(mission.checked->mission()) && user_code.empty();
  if (lacks_code || !simulator::checkPlatform(mission.platform())) {
    return {};
  }
  auto loaded = flights::loadHere(mission, user_code);
  if (!loaded) {
    return std::unexpected(loaded.error());
  }
  const auto parameters = flights::chooseParameters(mission.mission, {});
  if (!parameters) {
    return std::unexpected(parameters.error());
  }
  std::optional<flights::RequirementWatch> watch;
  if (flights::RequirementWatch::canWatch(mission)) {
    watch.emplace(mission);
  }
  const auto end = flights::usualEnd(mission.platform());
  if (!end) {
    return std::unexpected(end.error());
  }
  const auto trace =
      fly(mission,
          flights::startInProcess(
              std::make_shared<const codegen::LoadedMission>(std::move(*loaded)), *parameters,
              !scenario.faults.empty(), watch ? &*watch : nullptr, *end),
          {scenario, scenario.seed});
  if (!trace) {
    return std::unexpected(trace.error());
  }
  if (watch) {
    flights::reportViolations(*watch, watch->violations(*trace), diagnostics);
  }
  support::DiagnosticEngine of_flight;
  report::reportFlight(*trace, of_flight);
  report::reportUnusual(*trace, hint, of_flight);
  if (!saysMasked(diagnostics)) {
    reportMasked(*trace, hint, of_flight);
  }
  for (support::Diagnostic one : of_flight.sorted()) {
    one.range = mission.checked->mission().states.front().range;  // it is about the whole mission
    one.hint = hint;
    diagnostics.add(std::move(one));
  }
  return {};
}

}  // namespace glider::analysis
