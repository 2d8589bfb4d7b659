// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#ifndef GLIDER_RUNTIME_ABI_WINDOW_H
#define GLIDER_RUNTIME_ABI_WINDOW_H

/* Windows over a time or a stretch (ir/README.md, "Windows"), in memory that the compiler sizes. */

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef enum GliderWindowKind {
  kGliderMean,
  kGliderLowest,
  kGliderHighest,
  kGliderSpread, /* highest less lowest */
  kGliderSlope   /* of the line of least squares against time or the other sensor */
} GliderWindowKind;

typedef struct GliderWindowShape {
  double length;    /* s, or in the SI unit of what is stretched along; positive */
  double bin;       /* width of a bin, in the same unit; positive */
  uint32_t bins;    /* slots of memory: one more than bins can lie within the window */
  uint32_t kind;    /* GliderWindowKind */
  uint32_t stretch; /* 0: over time; 1: along another sensor */
  uint32_t reserved;
} GliderWindowShape;

/* Doubles of memory before the slots, and for each slot. memory[0] is the window's value. */
#define GLIDER_WINDOW_HEADER 5u
#define GLIDER_WINDOW_SLOT 4u
/* A reading older than this has left every stretch, s. */
#define GLIDER_STRETCH_MEMORY_S 1800.0

/* Empties the window, which now starts at mission time `time`, s. Its value is unknown. */
void gliderWindowStart(double* memory, const GliderWindowShape* shape, double time);

/* A tick of mission time `time`, s: takes the reading `value` at `along` (for a window over time:
   also the mission time) if `fresh` is not 0 and both are known, and computes the value again. */
void gliderWindowAdvance(double* memory, const GliderWindowShape* shape, double time, double along,
                         double value, uint32_t fresh);

#ifdef __cplusplus
}
#endif

#endif
