// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/client/client.h"
#include "runtime/log/format.h"
#include "runtime/log/mission_log.h"

namespace glider::runtime {

/// Writes the notes that this tick left in `context` (`log` statements, unknown values) to the log,
/// and sends them as text to the vehicle.
void tellNotes(const GliderContext& context, MissionLog& log, hooks::Client& client);

/// Adds the values of a note to its text. Not in programs of missions whose notes have none
/// (no_note_values.cpp), which so write no number.
void writeValues(const GliderContext& context, const GliderNote& note, Text& text);

}  // namespace glider::runtime
