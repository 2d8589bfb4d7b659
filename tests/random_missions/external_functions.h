/* SPDX-FileCopyrightText: 2026 The glidercc authors
   SPDX-License-Identifier: Apache-2.0 */

#ifndef GLIDER_TESTS_EXTERNAL_FUNCTIONS_H
#define GLIDER_TESTS_EXTERNAL_FUNCTIONS_H

/* The C functions and sensors of random missions, for the interpreter and for the boards. What they
   give depends on all that they were ever asked, so that a call too many, too few or out of order
   shows. */

#include <stdint.h>
#include <string.h>

typedef struct ExternalState {
  uint64_t memory;
} ExternalState;

/* What the functions' answers depend on from then on: `which` of them, and a number (all NaN are
 * one). */
static inline void externalAsked(ExternalState* state, uint32_t which, double number) {
  uint64_t bits = 0x7FF8000000000000u;
  if (number == number) {
    memcpy(&bits, &number, sizeof bits);
  }
  state->memory = (state->memory ^ bits ^ which) * 6364136223846793005u + 1442695040888963407u;
}

/* A number from about -8 to 24, or now and then one that is unknown, too large, or settles. */
static inline double externalAnswer(const ExternalState* state) {
  static const double kOdd[] = {0.0, -0.0, 1e300, -1e-310, 1.0, 2.5};
  const uint32_t high = (uint32_t)(state->memory >> 40);
  const double zero = 0.0;
  if (high % 11u == 0u) {
    return high % 2u == 0u ? zero / zero : 1.0 / zero;
  }
  if (high % 13u == 0u) {
    return kOdd[high % 6u];
  }
  return (double)(high % 4096u) / 128.0 - 8.0;
}

#endif
