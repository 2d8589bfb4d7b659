// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/core/tell_notes.h"

namespace glider::runtime {

void writeValues(const GliderContext& context, const GliderNote& note, Text& text) {
  for (uint32_t i = 0; i < note.count; ++i) {
    const double value = context.note_values[note.first + i];
    text.put(' ');
    value == value ? text.put(value) : text.put("unknown");
  }
}

}  // namespace glider::runtime
