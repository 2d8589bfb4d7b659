// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/client/client.h"
#include "runtime/log/mission_log.h"

namespace glider::runtime {

/// Writes the notes that this tick left in `context` (`log` statements, unknown values) to the log,
/// and sends them as text to the vehicle.
void tellNotes(const GliderContext& context, MissionLog& log, hooks::Client& client);

}  // namespace glider::runtime
