// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// In place of note_values.cpp in the program of a mission whose notes have no values.

#include "runtime/core/tell_notes.h"

namespace glider::runtime {

void writeValues(const GliderContext& /*context*/, const GliderNote& /*note*/, Text& /*text*/) {}

}  // namespace glider::runtime
