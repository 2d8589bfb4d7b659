// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "platforms/load/platform.h"
#include "vehicles/slocum/mission_files/mission_file.h"
#include "vehicles/slocum/rules/control.h"
#include "vehicles/slocum/rules/port/port_file.h"

#include <vector>

namespace glider::slocum::rules {

/// What keeps the vehicle from doing what the SBC commands by the port: a `yo`, a heading or a
/// surfacing of the SBC that is not as `build --dialect extctl` writes it, and what is in force
/// before the SBC's first command. All proofs rest on these.
std::vector<Disturbance> portDoubts(const MissionFile& vehicle, const PortFile& port,
                                    const platforms::Platform& platform);

}  // namespace glider::slocum::rules
