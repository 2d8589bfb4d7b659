// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/worlds/worlds.h"
#include "support/diagnostics/engine.h"
#include "vehicles/slocum/rules/vehicle_file.h"

#include <optional>
#include <string>

namespace glider::slocum::rules {

/// Reports what the vehicle of `file` would not do for the mission: commands that its hookbeh
/// refuses (GL3124); depths, times and voltages at which its abend aborts (GL3125).
void checkVehicleLimits(const ir::WrittenWorld& world, const VehicleFile& file,
                        support::DiagnosticEngine& diagnostics);

/// A line for the report if abend ends a mission whose end is not proved. That is not an error: the
/// bound may merely not have been found.
std::optional<std::string> endlessLine(const ir::WrittenWorld& world, const VehicleFile& file);

}  // namespace glider::slocum::rules
