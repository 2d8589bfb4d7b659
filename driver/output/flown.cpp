// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/output/flown.h"

#include "driver/terminal.h"
#include "flights/flight_setup.h"
#include "flights/logged_values.h"
#include "flights/mission_facts.h"
#include "report/warnings.h"
#include "support/diagnostics/engine.h"

namespace glider::driver {

std::vector<support::Diagnostic> judge(const support::Trace& trace, const Flown& flown,
                                       const std::vector<flights::FlownViolation>& violations,
                                       const simulator::Scenario& scenario) {
  support::DiagnosticEngine diagnostics;
  if (flown.mission != nullptr) {
    flights::reportMissingSensors(*flown.mission, scenario, diagnostics);
  }
  if (flown.watch != nullptr) {
    flights::reportViolations(*flown.watch, violations, diagnostics);
  }
  report::reportFlight(trace, diagnostics, flown.port_folder);
  report::reportRestless(trace,
                         "a condition that is still true after a transition causes the next one: "
                         "see the events for the cases, and `glidercc explain GL9378`",
                         diagnostics);
  reportDiagnostics(diagnostics,
                    flown.mission != nullptr ? flown.mission->sources() : support::SourceManager());
  return diagnostics.sorted();
}

void addFacts(const Flown& flown, const flights::LaunchChoice& launch,
              const flights::FlownOutcome& outcome, support::Trace& trace) {
  if (flown.mission == nullptr) {
    return;
  }
  const auto parameters = flights::chooseParameters(flown.mission->checked->mission(), launch);
  trace.facts = flights::missionFacts(*flown.mission, parameters.value_or(std::vector<double>()));
  flights::addLoggedValues(*flown.mission, trace);
  if (flown.watch != nullptr) {
    trace.facts.promises = flights::flownPromises(*flown.watch, *flown.mission->checked, outcome);
  }
}

}  // namespace glider::driver
