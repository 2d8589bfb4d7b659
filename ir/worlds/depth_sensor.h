// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"
#include "platforms/load/platform.h"

#include <optional>

namespace glider::ir {

/// The sensor of a mission that is the vehicle's own depth; none if the mission does not read it.
std::optional<SensorId> depthSensor(const Mission& mission, const platforms::Platform& platform);

}  // namespace glider::ir
