// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "platforms/load/platform.h"
#include "runtime/abi/imc_mission.h"
#include "runtime/abi/recon_mission.h"
#include "support/result.h"

/// What a program must know of a vehicle without the hooks, by the way in which it is steered.
namespace glider::codegen {

/// Whether programs for the vehicle speak IMC, or RECON, with it.
bool speaksImc(const platforms::Platform& platform);
bool speaksRecon(const platforms::Platform& platform);

/// What such a program must know. GL5001: a sensor names a source that no message has, or in
/// another unit.
support::Result<GliderImcMission> imcMissionOf(const platforms::Platform& platform);
support::Result<GliderReconMission> reconMissionOf(const platforms::Platform& platform);

}  // namespace glider::codegen
