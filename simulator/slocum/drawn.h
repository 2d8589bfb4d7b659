// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/campaign/draw_faults.h"
#include "vehicles/slocum/mission_files/mission_file.h"

namespace glider::simulator {

/// Writes what a campaign has drawn for the vehicle's own mission into `mission`.
void applyDrawn(const DrawnFaults& drawn, slocum::MissionFile& mission);

}  // namespace glider::simulator
