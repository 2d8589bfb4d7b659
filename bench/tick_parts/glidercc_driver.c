/* SPDX-FileCopyrightText: 2026 The glidercc authors
   SPDX-License-Identifier: Apache-2.0 */

/* Runs the ticks of a compiled mission: `driver TICKS STREAM`. Of the three sensors that the
   mission subscribes, in this order, STREAM 0 changes the first a little, 1 all of them a lot. */

#include "bench/tick_parts/stream.h"
#include "runtime/abi/runtime.h"

#include <stddef.h>

int main(int argc, char** argv) {
  const unsigned ticks = argc > 1 ? numberOf(argv[1]) : 0;
  const unsigned stream = argc > 2 ? numberOf(argv[2]) : 0;
  GliderUpdate updates[kSensors];
  for (unsigned i = 0; i < kSensors; ++i) {
    updates[i].id = gliderMission.sensors[i].id;
    updates[i].value = reading(stream, i, 0);
  }
  GliderContext* context =
      gliderStart(gliderContextMemory, &gliderMission, NULL, updates, kSensors);
  for (unsigned tick = 1; tick <= ticks; ++tick) {
    for (unsigned i = 0; i < kSensors; ++i) {
      updates[i].value = reading(stream, i, tick);
    }
    gliderStep(context, missionTime(tick), updates, stream == 0 ? 1 : kSensors);
  }
  return context->finished != 0 || context->state != 0;
}
