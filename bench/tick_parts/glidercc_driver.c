/* SPDX-FileCopyrightText: 2026 The glidercc authors
   SPDX-License-Identifier: Apache-2.0 */

/* Runs the ticks of a compiled mission: `driver TICKS STREAM [1]`. Of the three sensors that the
   mission subscribes, in this order, STREAM 0 changes the first a little, 1 all of them a lot. With
   the third argument 1 only the guards run, as in paper.c. */

#include "bench/tick_parts/stream.h"
#include "runtime/abi/runtime.h"

#include <stddef.h>

int main(int argc, char** argv) {
  const unsigned ticks = argc > 1 ? numberOf(argv[1]) : 0;
  const unsigned stream = argc > 2 ? numberOf(argv[2]) : 0;
  const unsigned alone = argc > 3 ? numberOf(argv[3]) : 0;
  GliderUpdate updates[kSensors];
  for (unsigned i = 0; i < kSensors; ++i) {
    updates[i].id = gliderMission.sensors[i].id;
    updates[i].value = reading(stream, i, 0);
  }
  GliderContext* context =
      gliderStart(gliderContextMemory, &gliderMission, NULL, updates, kSensors);
  unsigned fired = 0;
  for (unsigned tick = 1; alone && tick <= ticks; ++tick) {
    for (unsigned i = 0; i < kSensors; ++i) {
      context->readings[i].value = reading(stream, i, tick);
    }
    fired += gliderMission.states[context->state]->guards(context, 0) != GLIDER_NO_CASE;
  }
  for (unsigned tick = 1; !alone && tick <= ticks; ++tick) {
    for (unsigned i = 0; i < kSensors; ++i) {
      updates[i].value = reading(stream, i, tick);
    }
    gliderStep(context, missionTime(tick), updates, stream == 0 ? 1 : kSensors);
  }
  return context->finished != 0 || context->state != 0 || fired != 0;
}
