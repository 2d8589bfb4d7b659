// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/diagnostics/engine.h"
#include "support/trace/trace.h"

#include <cstddef>
#include <string>
#include <vector>

namespace glider::report {

/// How many of the SBC's instructions the vehicle refused.
size_t refusedInstructions(const support::Trace& trace);

/// True if there was an SBC and it never had control.
bool wasNeverInControl(const support::Trace& trace);

/// True if there was an SBC and hookprog understood it: otherwise the program is not an SBC, or one
/// of another version.
bool spokeTheProtocol(const support::Trace& trace);

/// Reports what went wrong in a flight: the vehicle aborted (GL9370), a command was refused
/// (GL9371), the mission was never in control (GL9372), hookbeh intervened (GL9375), the vehicle
/// touched the bottom (GL9376), ended on it (GL5215), or was not up at the end after an abort
/// (GL5216). Of several of a kind only the first is reported, with their number. `port_folder`: the
/// folder that flew, of a vehicle that is steered by its port; empty: none.
void reportFlight(const support::Trace& trace, support::DiagnosticEngine& diagnostics,
                  const std::string& port_folder = {});

/// Reports a mission that changed its state 20 times within 5 min (GL9378). `hint`: what to do.
void reportRestless(const support::Trace& trace, const std::string& hint,
                    support::DiagnosticEngine& diagnostics);

/// Reports what hardly any mission is meant to do (GL9378): it had not ended when the simulated
/// time was up, ended within a minute, or changed its state 20 times within 5 min. `hint`: what to
/// do.
void reportUnusual(const support::Trace& trace, const std::string& hint,
                   support::DiagnosticEngine& diagnostics);

/// What else the reader must know before any figure of the flight: the mission was another one, or
/// had not ended. The flight may be as it was meant. One sentence each, without a full stop.
std::vector<std::string> flightNotes(const support::Trace& trace);

/// All of these as a JSON array, those of `reported` first: {"code", "slug", "message", "hint"};
/// code and slug are empty for those that are not failures.
std::string warningsToJson(const std::vector<support::Diagnostic>& reported,
                           const std::vector<std::string>& others);

}  // namespace glider::report
