// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/core/tell_notes.h"

namespace glider::runtime {
namespace {

/// The text of a note with its values after it, as much as a notice holds.
void writeNote(const GliderContext& context, const GliderNote& note, char* out) {
  Text text(out, hooks::kMostNoteBytes);
  text.put(note.text);
  writeValues(context, note, text);
}

}  // namespace

void tellNotes(const GliderContext& context, MissionLog& log, hooks::Client& client) {
  for (uint32_t i = 0; i < context.note_count; ++i) {
    log.note(context, i);
    hooks::MissionNote told;
    told.mission_time_s = context.mission_time;
    told.kind = static_cast<uint8_t>(context.notes[i].kind);
    writeNote(context, context.notes[i], told.text);
    client.tell(told);
  }
  if (context.lost_notes != 0) {
    log.event(context.mission_time, LogEvent::NotesLost, LogDetail::None,
              static_cast<double>(context.lost_notes));
  }
}

}  // namespace glider::runtime
