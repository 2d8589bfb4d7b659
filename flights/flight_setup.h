// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "compiler/compilation.h"
#include "simulator/simulator.h"
#include "support/diagnostics/engine.h"

namespace glider::flights {

/// Reports each sensor that the mission reads or logs but the scenario's vehicle does not carry.
void reportMissingSensors(const compiler::Optimised& mission, const simulator::Scenario& scenario,
                          support::DiagnosticEngine& diagnostics);

/// Whether a mission needs code in C of the pilot's own, which the interpreter does not have.
bool needsCodeInC(const ir::Mission& mission);

/// Puts the names of the mission and its states, the texts of its guards and the sensors that it
/// lists into `setup`; `mission` must outlive it.
void describeMission(simulator::SimulationSetup& setup, const compiler::Optimised& mission);

}  // namespace glider::flights
