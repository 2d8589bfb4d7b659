// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"
#include "platforms/load/platform.h"
#include "runtime/abi/talk_mission.h"

namespace glider::codegen {

/// Whether the mission's program has a modem.
bool talks(const ir::Mission& mission);

/// What the program of such a mission must know of what it sends and receives.
GliderTalk talkMissionOf(const ir::Mission& mission, const platforms::Platform& platform);

}  // namespace glider::codegen
