/* SPDX-FileCopyrightText: 2026 The glidercc authors
   SPDX-License-Identifier: Apache-2.0 */

/* Drives the C that Copilot makes of Figure2.hs. `TICKS`. */

#include "bench/tick_parts/timing.h"

#include <stdint.h>

double time_s;
static unsigned transitions;

void step(void);
void transition(uint8_t state);

void transition(uint8_t state) {
  transitions += 1u + state;
}

int main(int argc, char** argv) {
  const unsigned ticks = argc > 1 ? numberOf(argv[1]) : 1000;
  const double begin = now();
  for (unsigned tick = 1; tick <= ticks; ++tick) {
    time_s = 400.0 * tick / ticks;
    step();
  }
  return report(now() - begin, ticks, transitions == 0);
}
