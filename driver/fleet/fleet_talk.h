// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "flights/fleet/fleet_file.h"
#include "ir/core/mission.h"
#include "platforms/load/platform.h"
#include "support/result.h"

#include <vector>

namespace glider::driver {

/// A vehicle of a fleet that talks, for checkTalk.
struct Talking {
  const flights::FleetVehicle* vehicle = nullptr;
  const ir::Mission* mission = nullptr;
  const platforms::Platform* platform = nullptr;
};

/// How long a slot of a vehicle's modem is, s; 0: its platform has none.
double slotOf(const platforms::Platform& platform);

/// Whether the vehicles of a fleet whose missions share something understand each other, and have
/// the time to take turns. GL9304, which names the vehicle.
support::Result<void> checkTalk(const flights::Fleet& fleet, const std::vector<Talking>& vehicles);

}  // namespace glider::driver
