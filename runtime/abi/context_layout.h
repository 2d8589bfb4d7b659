// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#ifndef GLIDER_RUNTIME_ABI_CONTEXT_LAYOUT_H
#define GLIDER_RUNTIME_ABI_CONTEXT_LAYOUT_H

/* Where the arrays of a running mission stand behind its GliderContext, in this order and each
   aligned for a double: readings, frames, memory, variables, temporals, calls, notes, note_values.
   Codegen computes the same from the board's DataLayout and sets GliderMission::context_bytes. */

#include "runtime/abi/glider_abi.h"

#include <stddef.h>

typedef struct GliderContextLayout {
  size_t readings; /* bytes from the start of the context */
  size_t frames;
  size_t memory;
  size_t variables;
  size_t temporals;
  size_t calls;
  size_t notes;
  size_t note_values;
  size_t bytes; /* in all */
} GliderContextLayout;

static inline size_t gliderAlignUp(size_t bytes) {
  return (bytes + 7u) & ~(size_t)7u;
}

static inline GliderContextLayout gliderContextLayout(uint32_t sensor_count, uint32_t stack_limit,
                                                      uint32_t memory_count,
                                                      uint32_t variable_count,
                                                      uint32_t temporal_slots,
                                                      uint32_t call_count) {
  GliderContextLayout layout;
  layout.readings = gliderAlignUp(sizeof(GliderContext));
  layout.frames = layout.readings + gliderAlignUp(sensor_count * sizeof(GliderReading));
  layout.memory = layout.frames + gliderAlignUp(stack_limit * sizeof(GliderFrame));
  layout.variables = layout.memory + memory_count * sizeof(GliderBehaviourMemory);
  layout.temporals = layout.variables + variable_count * sizeof(double);
  layout.calls = layout.temporals + temporal_slots * sizeof(double);
  layout.notes = layout.calls + call_count * sizeof(GliderCall);
  layout.note_values = layout.notes + gliderAlignUp(GLIDER_MOST_NOTES * sizeof(GliderNote));
  layout.bytes = layout.note_values + GLIDER_MOST_NOTE_VALUES * sizeof(double);
  return layout;
}

#endif
