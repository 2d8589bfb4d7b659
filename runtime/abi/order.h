// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#ifndef GLIDER_RUNTIME_ABI_ORDER_H
#define GLIDER_RUNTIME_ABI_ORDER_H

/* Doubles compared as whole numbers, which a processor without an FPU does in a tenth of the time.
   The compiler and the runtime share it. */

#include <stdint.h>
#include <string.h>

/* A whole number for each double, in the same order; unknown (the NaN that missions see) is above
   all others. +0 gives 0, -0 gives -1. */
static inline int64_t gliderOrder(double value) {
  int64_t bits;
  memcpy(&bits, &value, sizeof bits);
  return bits < 0 ? bits ^ INT64_MAX : bits;
}

#endif
