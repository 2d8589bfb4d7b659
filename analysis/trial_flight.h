// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "compiler/compilation.h"
#include "simulator/scenario/scenario.h"
#include "support/diagnostics/engine.h"
#include "support/result.h"

#include <string>
#include <vector>

namespace glider::analysis {

/// Flies the mission once with its default parameters, in this process, and reports what `sim`
/// reports of such a flight, violated requirements and broken assumptions among it, and what hardly
/// any mission is meant to do (GL9378), at the first state. `hint`: how to see the flight. Reports
/// nothing for a vehicle that is not simulated, and for a mission that needs code in C if there is
/// no `user_code`. Fails as flights::loadHere, flights::chooseParameters and simulator::simulate
/// do.
support::Result<void> reportTrialFlight(const compiler::Optimised& mission,
                                        const simulator::Scenario& scenario,
                                        const std::vector<std::string>& user_code,
                                        const std::string& hint,
                                        support::DiagnosticEngine& diagnostics);

}  // namespace glider::analysis
