// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/worlds/worlds.h"
#include "support/diagnostics/engine.h"
#include "vehicles/slocum/rules/vehicle_file.h"

#include <string>

namespace glider::slocum::rules {

/// On what every proof about the flight rests with this mission file: that hookbeh's commands fly.
/// "with skeleton.mi, in water of 35 m or more", or that findings in `diagnostics` doubt it.
std::string premiseWith(const ir::WidestWorld& world, const VehicleFile& file,
                        const support::DiagnosticEngine& diagnostics);

/// ", and only while `what`: see GL3125"; empty if nothing that was reported casts a doubt on it.
std::string onlyWhile(const char* what, const support::DiagnosticEngine& diagnostics);

}  // namespace glider::slocum::rules
