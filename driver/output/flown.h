// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "compiler/compilation.h"
#include "flights/launch_choice.h"
#include "flights/requirement_watch.h"
#include "simulator/scenario/scenario.h"
#include "support/diagnostics/diagnostic.h"
#include "support/trace/trace.h"

#include <string>
#include <vector>

namespace glider::driver {

/// What flies: the mission of the language (null: none), and what watches it (null: it is not
/// watched).
struct Flown {
  const compiler::Optimised* mission = nullptr;
  const flights::RequirementWatch* watch = nullptr;
  std::string port_folder;  ///< empty: not by the port
};

/// What went wrong in a flight: events of the vehicle, sensors that it did not carry, requirements
/// that it violated. Prints it too.
std::vector<support::Diagnostic> judge(const support::Trace& trace, const Flown& flown,
                                       const std::vector<flights::FlownViolation>& violations,
                                       const simulator::Scenario& scenario);

/// Adds to the trace what the mission says about its flight, and what it logged.
void addFacts(const Flown& flown, const flights::LaunchChoice& launch,
              const flights::FlownOutcome& outcome, support::Trace& trace);

}  // namespace glider::driver
