// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "platforms/load/platform.h"
#include "runtime/abi/recon_mission.h"
#include "support/result.h"

namespace glider::codegen {

/// Whether programs for the vehicle speak RECON with it.
bool speaksRecon(const platforms::Platform& platform);

/// What such a program must know. GL5001: a sensor names a source that no message has, or in
/// another unit.
support::Result<GliderReconMission> reconMissionOf(const platforms::Platform& platform);

}  // namespace glider::codegen
