// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#ifndef GLIDER_RUNTIME_ABI_CONTEXT_LAYOUT_H
#define GLIDER_RUNTIME_ABI_CONTEXT_LAYOUT_H

/* The positions of a running mission's arrays behind its GliderContext, in this order and each
   aligned for a double: readings, frames, memory, variables, temporals, calls, intervals, notes,
   note_values. Codegen computes the same from the board's DataLayout and sets
   GliderMission::context_bytes. */

#include "runtime/abi/glider_abi.h"

#include <stddef.h>

typedef struct GliderContextLayout {
  size_t readings; /* bytes from the start of the context */
  size_t frames;
  size_t memory;
  size_t variables;
  size_t temporals;
  size_t calls;
  size_t intervals;
  size_t notes;
  size_t note_values;
  size_t bytes; /* in all */
} GliderContextLayout;

static inline size_t gliderAlignUp(size_t bytes) {
  return (bytes + 7u) & ~(size_t)7u;
}

static inline GliderContextLayout gliderContextLayout(const GliderMission* mission) {
  GliderContextLayout layout;
  layout.readings = gliderAlignUp(sizeof(GliderContext));
  layout.frames = layout.readings + gliderAlignUp(mission->sensor_count * sizeof(GliderReading));
  layout.memory = layout.frames + gliderAlignUp(mission->stack_limit * sizeof(GliderFrame));
  layout.variables = layout.memory + mission->memory_count * sizeof(GliderBehaviourMemory);
  layout.temporals = layout.variables + mission->variable_count * sizeof(double);
  layout.calls = layout.temporals + mission->temporal_slots * sizeof(double);
  layout.intervals = layout.calls + mission->call_count * sizeof(GliderCall);
  layout.notes = layout.intervals + gliderAlignUp(mission->interval_count * sizeof(uint32_t));
  layout.note_values = layout.notes + gliderAlignUp(GLIDER_MOST_NOTES * sizeof(GliderNote));
  layout.bytes = layout.note_values + GLIDER_MOST_NOTE_VALUES * sizeof(double);
  return layout;
}

#endif
