/* SPDX-FileCopyrightText: 2026 The glidercc authors
   SPDX-License-Identifier: Apache-2.0 */

/* Nanoseconds of one tick of Figure 2, compiled by glidercc, in s1: `TICKS`, then 1 if every sensor
   changes on each tick, then 1 for its guards alone, as the other programs have them. */

#include "bench/tick_parts/timing.h"
#include "runtime/abi/runtime.h"

#include <stddef.h>

int main(int argc, char** argv) {
  const unsigned ticks = argc > 1 ? numberOf(argv[1]) : 1000;
  const unsigned all = argc > 2 ? numberOf(argv[2]) : 0;
  const unsigned alone = argc > 3 ? numberOf(argv[3]) : 0;
  GliderUpdate updates[8];
  const unsigned count = all ? gliderMission.sensor_count : 0;
  for (unsigned i = 0; i < gliderMission.sensor_count; ++i) {
    updates[i].id = gliderMission.sensors[i].id;
    updates[i].value = 1;
  }
  GliderContext* context =
      gliderStart(gliderContextMemory, &gliderMission, NULL, updates, gliderMission.sensor_count);
  const double begin = now();
  unsigned fired = 0;
  for (unsigned tick = 1; alone && tick <= ticks; ++tick) {
    context->mission_time = 400.0 * tick / ticks;
    fired += gliderMission.states[context->state]->guards(context, 0) != GLIDER_NO_CASE;
  }
  for (unsigned tick = 1; !alone && tick <= ticks; ++tick) {
    for (unsigned i = 0; i < count; ++i) {
      updates[i].value = 1 + 0.001 * (tick % 64);
    }
    gliderStep(context, 400.0 * tick / ticks, updates, count);
  }
  return report(now() - begin, ticks, context->state == 0 && fired == 0);
}
