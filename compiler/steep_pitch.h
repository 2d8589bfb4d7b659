// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"
#include "platforms/load/platform.h"

namespace glider::compiler {

/// Gives the vehicle the overshoot of its steep dives if the mission may command one: every proof,
/// check and summary of the mission is then about that vehicle.
void allowForSteepPitch(const ir::Mission& mission, platforms::Envelope& envelope);

}  // namespace glider::compiler
