// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#ifndef GLIDER_RUNTIME_ABI_IMC_MISSION_H
#define GLIDER_RUNTIME_ABI_IMC_MISSION_H

#include <stdint.h>

/* Sensors of a vehicle that are read from its messages. */
#define GLIDER_MOST_IMC_READINGS 64

/* What the program on the SBC must know of a vehicle that is steered by IMC. The compiler writes
   one into each program for it, as `gliderImc`. No padding: it is the same on every board. */
typedef struct GliderImcMission {
  double greatest_depth_m;
  double slowest_m_s; /* through the water, under command */
  double fastest_m_s;
  double usual_m_s;     /* to the surface, and before the first command */
  double timeout_s;     /* after so long without a Reference the vehicle stops and floats up */
  double loiter_m;      /* radius of the circle at a waypoint */
  double start_depth_m; /* the plan is not started while the vehicle is deeper */
  uint32_t vehicle;     /* its address; 0: of the first that reports */
  uint32_t count;       /* of the readings */
  uint16_t sensors[GLIDER_MOST_IMC_READINGS]; /* their numbers in the platform file */
  uint16_t sources[GLIDER_MOST_IMC_READINGS]; /* rows of runtime/imc/readings.def */
} GliderImcMission;

#endif
