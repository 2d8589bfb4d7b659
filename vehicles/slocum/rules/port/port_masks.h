// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "vehicles/slocum/mission_files/mission_file.h"
#include "vehicles/slocum/rules/control.h"
#include "vehicles/slocum/rules/port/port_file.h"

#include <vector>

namespace glider::slocum::rules {

/// What of `vehicle` replaces the SBC's commands for a time, in the order of the file: a
/// `surface` that starts at certain times, a behaviour that steers above the SBC's heading. What
/// dives is not among it: portWhole() refuses it (GL3127). Nor is what waits for contact.
std::vector<Disturbance> portMasks(const MissionFile& vehicle, const PortFile& port);

}  // namespace glider::slocum::rules
