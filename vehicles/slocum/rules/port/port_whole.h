// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "platforms/load/platform.h"
#include "vehicles/slocum/mission_files/mission_file.h"
#include "vehicles/slocum/port_files/port_plan.h"
#include "vehicles/slocum/rules/port/port_file.h"
#include "vehicles/slocum/rules/whole.h"

#include <string>
#include <vector>

namespace glider::slocum::rules {

/// What brings the vehicle up when the SBC no longer steers by the port, for any depths and
/// angles that it has sent last. Commands of the SBC are not acknowledged, so even after `exit`
/// only the vehicle's own behaviours count.
Whole portWhole(const MissionFile& vehicle, const PortFile& port,
                const platforms::Platform& platform);

/// The same of the mission file that is planned. It is written so that all is proved.
Whole portWhole(const PortPlan& plan, const platforms::Platform& platform);

/// What hookbeh does, and what the vehicle has in its place: lines for the report.
std::vector<std::string> missingGuards(const VehicleFile& file);

}  // namespace glider::slocum::rules
