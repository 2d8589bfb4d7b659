// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "vehicles/slocum/dock/dock_run.h"

#include <string>
#include <vector>

namespace glider::slocum {

// Each plays its part until the check ends, and adds what it found to `result`.

/// This computer plays the vehicle, to an SBC. `told`: the user has said so; else
/// no vehicle reported.
void playVehicle(DockRun& run, bool told, vehicles::DockResult& result);
/// This computer plays the SBC, to a vehicle, which has already sent the sentences `arrived`.
void playSbc(DockRun& run, const std::vector<std::string>& arrived, vehicles::DockResult& result);

}  // namespace glider::slocum
