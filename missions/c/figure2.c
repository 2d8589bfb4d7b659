/* SPDX-FileCopyrightText: 2026 The glidercc authors
   SPDX-License-Identifier: Apache-2.0 */

/* Fig. 2 of the paper, written out in C the way Fig. 3 does it for one state: an event list for
   each state, the commands of its profile and route, its transitions. */

#include "runtime/c/glider.h"

enum state { S1, S2, S3, STATES };

/* All that the program needs to continue after a power cut. */
static struct {
  double min, max;
  enum state current;
  enum state stack[1];
  int depth_of_stack;
} own;

/* The state's route and profile, as on entry. */
static void fly(enum state state) {
  static const double deepest[STATES] = {10, 20, 20};
  own.current = state;
  own.min = 5;
  own.max = deepest[state];
  setDepths(own.min, own.max);
  setPitches(.454, .454);
  switch (state) {
    case S1:
      steerTo(39.175, -73.83009666666667); /* 3910.5, -7349.8058 */
      break;
    case S2:
      drift();
      break;
    default:
      steerTo(39.175, -73.82509666666667); /* 3910.5, -7349.5058 */
      break;
  }
  if (gliderSensor(M_DEPTH) >= own.max) {
    climb();
  } else {
    dive();
  }
}

static void call(enum state state) {
  const double number = state + 1;
  gliderLog("calls s", &number, 1);
  own.stack[own.depth_of_stack++] = own.current;
  fly(state);
}

static void back(void) {
  fly(own.stack[--own.depth_of_stack]);
}

int main(int argc, char** argv) {
  const gliderThermo thermo = {10, 10};
  const double callAt = 500, returnAt = 1500, gotoAt = 2000, exitAt = 2500;
  eventList el[STATES], retEl;
  event iter = NULL;
  event reachMinDepth = EVENT(LEQ, M_DEPTH, &own.min);
  event reachMaxDepth = EVENT(GEQ, M_DEPTH, &own.max);
  event tempChange = CUSTOM_EVENT(thermoMet, &thermo);
  event toS3 = EVENT(GEQ, MISSION_TIME, &gotoAt);
  event toS2 = EVENT(GEQ, MISSION_TIME, &callAt);
  event fromS2 = EVENT(GEQ, MISSION_TIME, &returnAt);
  event theEnd = EVENT(GEQ, MISSION_TIME, &exitAt);
  for (int s = S1; s < STATES; ++s) {
    if (!(el[s] = newEventList()) || addEvent(el[s], reachMinDepth) ||
        addEvent(el[s], reachMaxDepth)) {
      return 1;
    }
  }
  if (addEvent(el[S1], toS3) || addEvent(el[S1], toS2) || addEvent(el[S2], tempChange) ||
      addEvent(el[S2], fromS2) || addEvent(el[S3], theEnd) || useSensor(M_PITCH) ||
      keepState(&own, sizeof own)) {
    return 1;
  }
  const int status = gliderOpen(argc, argv, "figure2");
  if (status) {
    return status;
  }
  fly(S1);
  while ((retEl = gliderRun(el[own.current]))) {
    const enum state ran = own.current;
    const double now = gliderSensor(MISSION_TIME);
    while ((iter = nextEvent(retEl, iter))) {
      if (own.current != ran) {
        continue; /* of a state that was left */
      }
      if (iter == reachMinDepth) {
        dive();
      }
      if (iter == reachMaxDepth) {
        climb();
      }
      if (iter == tempChange) {
        trackThermo(&own.min, &own.max, 10, 10);
      }
      if (iter == toS3) {
        fly(S3);
      }
      if (iter == toS2 && now < returnAt) {
        call(S2);
      }
      if (iter == fromS2) {
        back();
      }
      if (iter == theEnd) {
        releaseControl();
      }
    }
  }
  return gliderExitStatus();
}
