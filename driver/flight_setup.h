// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "driver/compilation.h"
#include "simulator/simulator.h"
#include "support/diagnostics/engine.h"

#include <memory>
#include <string>

namespace glider::driver {

/// Compiles `mission` as it is to be flown and shows its diagnostics; null with `status` set when
/// it has errors or cannot be read.
std::unique_ptr<Compilation> compileForFlight(const std::string& mission, int& status);

/// The vehicle that `compilation`'s mission is for; that of glidercc's own platform file without
/// one.
support::Result<platforms::Platform> platformOf(const Compilation* compilation);

/// Reports each sensor that the mission reads or logs and the scenario's vehicle does not carry.
void reportMissingSensors(const Compilation& compilation, const simulator::Scenario& scenario,
                          support::DiagnosticEngine& diagnostics);

/// Puts the mission's name, its states' and the texts of its guards into `setup`; `compilation`
/// must live as long.
void describeMission(simulator::SimulationSetup& setup, const Compilation& compilation);

}  // namespace glider::driver
