// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/client/client.h"
#include "runtime/log/mission_log.h"

namespace glider::runtime {

/// What this tick has left in `context` of `log` statements and unknown values: to the log, and as
/// texts to the vehicle.
void tellNotes(const GliderContext& context, MissionLog& log, hooks::Client& client);

}  // namespace glider::runtime
