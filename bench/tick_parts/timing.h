/* SPDX-FileCopyrightText: 2026 The glidercc authors
   SPDX-License-Identifier: Apache-2.0 */

#ifndef GLIDER_BENCH_TICK_PARTS_TIMING_H
#define GLIDER_BENCH_TICK_PARTS_TIMING_H

#include "bench/tick_parts/stream.h"

#include <stdio.h>
#include <time.h>

static double now(void) {
  struct timespec time;
  clock_gettime(CLOCK_MONOTONIC, &time);
  return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

/* Prints nanoseconds a tick; the exit status. */
static int report(double seconds, unsigned ticks, int right) {
  printf("%.3f\n", 1e9 * seconds / ticks);
  return right ? 0 : 1;
}

#endif
