// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#ifndef GLIDER_RUNTIME_ABI_PORT_MISSION_H
#define GLIDER_RUNTIME_ABI_PORT_MISSION_H

#include <stdint.h>

/* What the program on the SBC must know of the mission file that was written with it. The compiler
   writes one into each program for the vehicle's port, as `gliderPort`. */
typedef struct GliderPortMission {
  double greatest_depth_m;
  double steepest_pitch_rad;   /* magnitude */
  double shallowest_pitch_rad; /* magnitude */
  double hold_m;     /* the yo between a target depth and this much beside it holds the depth */
  uint32_t program;  /* in u_mission_param_l while that mission file flies */
  uint32_t latitude; /* numbers of these sensors in the platform file */
  uint32_t longitude;
  uint32_t depth_state;   /* the same; one that no sensor has: there is none */
  uint32_t mission_modes; /* 1: the release starts behaviours by bits of u_mission_mode */
} GliderPortMission;

/* The bits of u_mission_mode, if the release has them. */
enum GliderPortMode {
  kGliderPortModeSurface = 1, /* come up */
  kGliderPortModeWaypoint = 4 /* steer to the waypoint, not by the heading */
};

#endif
