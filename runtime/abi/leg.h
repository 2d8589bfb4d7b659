// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#ifndef GLIDER_RUNTIME_ABI_LEG_H
#define GLIDER_RUNTIME_ABI_LEG_H

/* Windows over a leg: a dive or a climb (ir/README.md, "Legs"). Their memory does not depend on how
   long a leg is. */

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef enum GliderLegKind {
  kGliderLegMean,
  kGliderLegLowest,
  kGliderLegHighest,
  kGliderLegSpread,    /* highest less lowest */
  kGliderLegAtLowest,  /* the other value where the lowest was */
  kGliderLegAtHighest, /* the other value where the highest was */
  kGliderLegSteepest, /* gliderSteepestAdvance: the steepest slope of the value against the other */
  kGliderLegAtSteepest, /* gliderSteepestAdvance: the other value in the middle of that slope */
  kGliderLegNumber      /* of legs that have begun */
} GliderLegKind;

typedef struct GliderLegShape {
  double dive; /* the values of the vehicle's state that are legs; may be equal */
  double climb;
  uint32_t kind; /* GliderLegKind */
  uint32_t last; /* 0: the present leg; 1: the one before */
} GliderLegShape;

/* Doubles of memory. memory[0] is the window's value. */
#define GLIDER_LEG_MEMORY 21u
#define GLIDER_STEEPEST_MEMORY 25u
/* Slopes are those between layers of readings, each this thick in the other value, m. */
#define GLIDER_LEG_LAYER 2.0
/* A leg is not whole if it has a longer time without a tick, s: a call, or a power cut. */
#define GLIDER_LEG_GAP_S 60.0

/* Empties the window, which now starts at mission time `time`, s. */
void gliderLegStart(double* memory, double time);

/* A tick of mission time `time`, s: takes the reading `value`, with the other value `at`, if
   `fresh` is not 0, the vehicle's state `phase` is one of a leg, and both are known. In the tick in
   which the window starts it takes none, and its value is unknown. */
void gliderLegAdvance(double* memory, const GliderLegShape* shape, double time, double phase,
                      double value, double at, uint32_t fresh);

/* The same for the windows of the kinds kGliderLegSteepest and kGliderLegAtSteepest. */
void gliderSteepestStart(double* memory, double time);
void gliderSteepestAdvance(double* memory, const GliderLegShape* shape, double time, double phase,
                           double value, double at, uint32_t fresh);

#ifdef __cplusplus
}
#endif

#endif
