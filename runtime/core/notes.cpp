// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/abi/glider_abi.h"
#include "runtime/core/assert.h"

extern "C" void gliderNote(GliderContext* context, uint32_t kind, const char* text,
                           const double* values, uint32_t count) {
  if (!GLIDER_ASSERT(*context, context->note_count <= GLIDER_MOST_NOTES, NoteRoom) ||
      !GLIDER_ASSERT(*context, context->note_value_count <= GLIDER_MOST_NOTE_VALUES,
                     NoteValueRoom)) {
    return;
  }
  if (context->note_count == GLIDER_MOST_NOTES) {
    ++context->lost_notes;
    return;
  }
  GliderNote& note = context->notes[context->note_count++];
  const uint32_t room = GLIDER_MOST_NOTE_VALUES - context->note_value_count;
  note.text = text;
  note.kind = kind;
  note.first = context->note_value_count;
  note.count = count < room ? count : room;
  context->lost_notes += count > room ? 1U : 0U;
  for (uint32_t i = 0; i < note.count; ++i) {
    context->note_values[context->note_value_count++] = values[i];
  }
}
