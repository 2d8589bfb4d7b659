/* SPDX-FileCopyrightText: 2026 The glidercc authors
   SPDX-License-Identifier: Apache-2.0 */

/* The same guards in the paper's way: an event list of predicates with their data, all asked on
   each tick (`gliderRun`). bench/tick_parts/cases.h, made by bench/tick, has `kCases` and `kData`.
 */

#include "bench/tick_parts/cases.h"
#include "bench/tick_parts/stream.h"

#include <stddef.h>

static double sensors[kSensors];

typedef struct Event {
  int (*test)(const Data*);
  const Data* data;
} Event;

static int deepAndCold(const Data* data) {
  return sensors[0] > data->first && sensors[1] < data->second;
}
static int coldAndSteep(const Data* data) {
  return sensors[1] > data->first && sensors[2] < data->second;
}
static int steepAndDeep(const Data* data) {
  return sensors[2] > data->first && sensors[0] < data->second;
}

static Event list[kCases];

static unsigned gliderRun(unsigned* fired) {
  unsigned count = 0;
  for (unsigned i = 0; i < kCases; ++i) {
    if (list[i].test(list[i].data)) {
      fired[count++] = i;
    }
  }
  return count;
}

int main(int argc, char** argv) {
  int (*const kTests[])(const Data*) = {deepAndCold, coldAndSteep, steepAndDeep};
  static unsigned fired[kCases];
  const unsigned ticks = argc > 1 ? numberOf(argv[1]) : 0;
  const unsigned stream = argc > 2 ? numberOf(argv[2]) : 0;
  for (unsigned i = 0; i < kCases; ++i) {
    list[i].test = kTests[i % 3];
    list[i].data = &kData[i];
  }
  unsigned all = 0;
  for (unsigned tick = 1; tick <= ticks; ++tick) {
    for (unsigned i = 0; i < kSensors; ++i) {
      sensors[i] = reading(stream, i, tick);
    }
    all += gliderRun(fired);
  }
  return all != 0;
}
