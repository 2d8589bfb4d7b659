/* SPDX-FileCopyrightText: 2026 The glidercc authors
   SPDX-License-Identifier: Apache-2.0 */

/* A flightprofile: dives in steps with a rest on each, and comes up in one climb. */

#include "staircase.h"

#include <platforms/slocum_sensors.h>

static const double kPitch = 0.4538; /* rad, 26 degrees */

/* The state's own memory: zero when the mission starts. Numbers only: checkpoints keep it. */
typedef struct Stairs {
  double target; /* m: depth of the current step; 0 before the first */
  double since;  /* s: mission time at which it was reached; -1: not reached yet */
  int32_t up;    /* 1 on the climb */
} Stairs;
_Static_assert(sizeof(Stairs) <= sizeof(GliderBehaviourMemory), "the memory has room for it");

static void aimAt(Stairs* stairs, double depth) {
  stairs->target = depth;
  stairs->since = -1;
}

/* Leaves the step: begins the next one, or the climb. */
static void goOn(Stairs* stairs, double top, double bottom, double step) {
  if (stairs->up) {
    stairs->up = 0;
    aimAt(stairs, top + step < bottom ? top + step : bottom);
  } else if (stairs->target >= bottom) {
    stairs->up = 1;
    aimAt(stairs, top);
  } else {
    aimAt(stairs, stairs->target + step < bottom ? stairs->target + step : bottom);
  }
}

/* Called on every tick in which the state is current; `phase` says why (GliderPhase). */
void profile_staircase(GliderContext* context, GliderBehaviourMemory* memory, uint32_t phase,
                       double top, double bottom, double step, double rest) {
  Stairs* const stairs = (Stairs*)memory;
  const double depth = gliderRead(context, GLIDER_M_DEPTH);
  const double now = gliderMissionTime(context);
  (void)phase;
  if (stairs->target == 0) {
    aimAt(stairs, top + step < bottom ? top + step : bottom);
  }
  /* An unknown depth compares as false: the glider continues as before. */
  const int reached = stairs->up ? depth <= stairs->target : depth >= stairs->target - 1;
  if (reached && stairs->since < 0) {
    stairs->since = now;
  }
  if (stairs->since >= 0 && (stairs->up || now - stairs->since >= rest)) {
    goOn(stairs, top, bottom, step);
  }
  if (stairs->up) {
    gliderAscend(context, stairs->target, kPitch);
  } else if (stairs->since >= 0) {
    gliderHover(context, stairs->target);
  } else {
    gliderDescend(context, stairs->target, kPitch);
  }
}
