/* SPDX-FileCopyrightText: 2026 The glidercc authors
   SPDX-License-Identifier: Apache-2.0 */

/* A mission in C: every dive goes 5 m deeper than the previous one, down to 40 m, until the water
   is colder than 4 degC or half an hour has passed. Run as
   deeper --port /dev/ttyS1 --log deeper.log --checkpoint deeper.state */

#include <runtime/c/glider.h>

static const double kDeepest = 40, kStep = 5;

int main(int argc, char** argv) {
  double top = 5, bottom = 10;
  const double end = 1800, cold = 4;
  eventList events = newEventList();
  event high = EVENT(LEQ, M_DEPTH, &top);
  event deep = EVENT(GEQ, M_DEPTH, &bottom);
  event icy = EVENT(LESS, SCI_WATER_TEMP, &cold);
  event over = EVENT(GEQ, MISSION_TIME, &end);
  if (!events || addEvent(events, high) || addEvent(events, deep) || addEvent(events, icy) ||
      addEvent(events, over)) {
    return 1;
  }
  /* All it needs to continue after a power cut: top never changes. */
  if (keepState(&bottom, sizeof bottom)) {
    return 1;
  }
  const int failed = gliderOpen(argc, argv, "deeper");
  if (failed) {
    return failed;
  }
  setDepths(top, bottom);
  setPitches(.454, .454);
  drift();
  dive();
  for (eventList fired; (fired = gliderRun(events));) {
    for (event e = NULL; (e = nextEvent(fired, e));) {
      if (e == deep) {
        climb();
        bottom = bottom + kStep < kDeepest ? bottom + kStep : kDeepest;
        gliderLog("next bottom", &bottom, 1);
      } else if (e == high) {
        setDepths(top, bottom);
        dive();
      } else {
        releaseControl(); /* icy, or over */
      }
    }
  }
  return gliderExitStatus();
}
