/* SPDX-FileCopyrightText: 2026 The glidercc authors
   SPDX-License-Identifier: Apache-2.0 */

/* Fig. 3 of the paper, completed: tracks a thermocline for 1000 s. Run it as a board's mission:
   figure3 --port /dev/ttyS1 */

#include "runtime/c/glider.h"

int main(int argc, char** argv) {
  double min, max;
  const double end = 1000;
  const gliderThermo thermo = {10, 10};
  eventList el = newEventList(), retEl;
  event iter = NULL;
  event reachMinDepth = EVENT(LEQ, M_DEPTH, &min);
  event reachMaxDepth = EVENT(GEQ, M_DEPTH, &max);
  event tempChange = CUSTOM_EVENT(thermoMet, &thermo);
  event timeIsUp = EVENT(GEQ, MISSION_TIME, &end);
  addEvent(el, reachMinDepth);
  addEvent(el, reachMaxDepth);
  addEvent(el, tempChange);
  addEvent(el, timeIsUp);

  const int failed = gliderOpen(argc, argv, "figure3");
  if (failed) {
    return failed;
  }
  min = 5;
  max = 20;
  setDepths(min, max);
  setPitches(.454, .454);
  dive();
  while ((retEl = gliderRun(el))) {
    while ((iter = nextEvent(retEl, iter))) {
      if (iter == reachMinDepth) {
        dive();
      }
      if (iter == reachMaxDepth) {
        climb();
      }
      if (iter == tempChange) {
        trackThermo(&min, &max, 10, 10);
      }
      if (iter == timeIsUp) {
        releaseControl();
      }
    }
  }
  return gliderExitStatus();
}
