// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#ifndef GLIDER_RUNTIME_ABI_RECON_MISSION_H
#define GLIDER_RUNTIME_ABI_RECON_MISSION_H

#include <stdint.h>

/* Sensors of a vehicle that are read from its messages. */
#define GLIDER_MOST_RECON_READINGS 64

/* What the program on the SBC must know of a vehicle that is steered by RECON. The compiler writes
   one into each program for it, as `gliderRecon`. No padding: it is the same on every board. */
typedef struct GliderReconMission {
  double greatest_depth_m;
  double slowest_m_s; /* through the water, under command */
  double fastest_m_s;
  double usual_m_s;                             /* to the surface */
  uint32_t count;                               /* of the readings */
  uint32_t unused;                              /* 0 */
  uint16_t sensors[GLIDER_MOST_RECON_READINGS]; /* their numbers in the platform file */
  uint16_t sources[GLIDER_MOST_RECON_READINGS]; /* rows of runtime/recon/readings.def */
} GliderReconMission;

#endif
