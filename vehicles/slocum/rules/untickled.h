// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/worlds/worlds.h"
#include "support/diagnostics/engine.h"
#include "vehicles/slocum/rules/layers.h"
#include "vehicles/slocum/rules/vehicle_file.h"

#include <span>

namespace glider::slocum::rules {

/// Reports that the vehicle may have no fix and no contact for longer than `abend` allows, unless
/// one of the `layers` certainly brings it up before: GL3125 if the mission may be under water for
/// so long and no command of it leads to the surface; otherwise GL3131, as the bound on that time
/// may be far above what happens.
void checkUntickled(const ir::WrittenWorld& world, const VehicleFile& file,
                    std::span<const Layer> layers, support::DiagnosticEngine& diagnostics);

}  // namespace glider::slocum::rules
