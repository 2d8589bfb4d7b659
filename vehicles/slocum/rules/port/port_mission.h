// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "vehicles/own_mission.h"
#include "vehicles/slocum/mission_files/mission_file.h"

#include <memory>
#include <string>

namespace glider::slocum::rules {

/// The vehicle's own mission for its port, read from `path` (port_file.h).
std::unique_ptr<vehicles::OwnMission> portMission(MissionFile file, std::string path);

}  // namespace glider::slocum::rules
