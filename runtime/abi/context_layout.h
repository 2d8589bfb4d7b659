// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#ifndef GLIDER_RUNTIME_ABI_CONTEXT_LAYOUT_H
#define GLIDER_RUNTIME_ABI_CONTEXT_LAYOUT_H

/* Where the arrays of a running mission stand behind its GliderContext, in this order and each
   aligned for a double: readings, frames, memory. Codegen computes the same from the board's
   DataLayout and sets GliderMission::context_bytes. */

#include "runtime/abi/glider_abi.h"

#include <stddef.h>

typedef struct GliderContextLayout {
  size_t readings; /* bytes from the start of the context */
  size_t frames;
  size_t memory;
  size_t bytes; /* in all */
} GliderContextLayout;

static inline size_t gliderAlignUp(size_t bytes) {
  return (bytes + 7u) & ~(size_t)7u;
}

static inline GliderContextLayout gliderContextLayout(uint32_t sensor_count, uint32_t stack_limit,
                                                      uint32_t memory_count) {
  GliderContextLayout layout;
  layout.readings = gliderAlignUp(sizeof(GliderContext));
  layout.frames = layout.readings + gliderAlignUp(sensor_count * sizeof(GliderReading));
  layout.memory = layout.frames + gliderAlignUp(stack_limit * sizeof(GliderFrame));
  layout.bytes = layout.memory + memory_count * sizeof(GliderBehaviourMemory);
  return layout;
}

#endif
