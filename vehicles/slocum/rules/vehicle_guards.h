// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/worlds/worlds.h"
#include "support/diagnostics/engine.h"
#include "vehicles/slocum/rules/layers.h"
#include "vehicles/slocum/rules/vehicle_file.h"

#include <span>

namespace glider::slocum::rules {

/// Reports where hookbeh or abend of `file` intervenes although the vehicle is healthy: dives that
/// turn past max_depth (GL3130, GL3131) or overdepth (GL3125, GL3131), cases that min_altitude
/// forestalls (GL3131), and dives of the file's own `layers` past them.
void checkGuards(const ir::WrittenWorld& world, const VehicleFile& file,
                 std::span<const Layer> layers, support::DiagnosticEngine& diagnostics);

/// Reports hovers that last longer than samedepth_for of abend (GL3125).
void checkSameDepth(const ir::WrittenWorld& world, const VehicleFile& file,
                    support::DiagnosticEngine& diagnostics);

}  // namespace glider::slocum::rules
