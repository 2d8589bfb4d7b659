// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/worlds/worlds.h"
#include "support/diagnostics/engine.h"
#include "vehicles/slocum/rules/layers.h"
#include "vehicles/slocum/rules/vehicle_file.h"

#include <span>

namespace glider::slocum::rules {

/// Reports that the mission may stay under water for longer than `abend` allows without a fix or
/// contact, and that none of the `layers` brings the vehicle up before: GL3125 if no command leads
/// to the surface, otherwise GL3131, as the bound on that time may be far above what happens.
void checkUntickled(const ir::WrittenWorld& world, const VehicleFile& file,
                    std::span<const Layer> layers, support::DiagnosticEngine& diagnostics);

}  // namespace glider::slocum::rules
