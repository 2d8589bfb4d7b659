// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#ifndef GLIDER_RUNTIME_ABI_BEHAVIOUR_H
#define GLIDER_RUNTIME_ABI_BEHAVIOUR_H

/* For authors of a flightprofile or flightroute in C or C++.

   `extern flightprofile yo(top: length, …)` binds to what `glidercc build --emit header` declares:
       void profile_yo(GliderContext*, GliderBehaviourMemory*, uint32_t phase, double top, …)
   one double a parameter, SI units (positions: degrees), NaN for unknown. The memory is zero when
   the mission starts, and the state's own: it lives on through calls and re-entry. */

#include "runtime/abi/glider_abi.h"

#ifdef __cplusplus
extern "C" {
#endif

/* This tick's reading of the sensor with platform number `id`
   (platforms/slocum_sensors.h of the vehicle `slocum`), SI units; NaN if it is unknown or this
   mission does not subscribe it. */
double gliderRead(const GliderContext* context, uint32_t id);

/* The number of the vehicle's sensor with this role (hooks/protocol/roles.def), GLIDER_NO_SENSOR if
   it has none: for behaviours that fly every vehicle. */
uint32_t gliderSensorOf(const GliderContext* context, GliderRole role);

/* Seconds since the newest frame that held the sensor; 0 if this tick's did. NaN for a sensor
 * never seen or not subscribed. */
double gliderAge(const GliderContext* context, uint32_t id);

/* Seconds since the mission got control. */
double gliderMissionTime(const GliderContext* context);

/* Vehicle commands. A command equal to the one in force has no effect; one with an unknown (NaN)
   value has no effect and is counted and logged. Depths in m, pitch in rad (magnitude; the sign
   follows from the direction), heading in rad clockwise from north, positions in degrees, the
   angle of the fin in rad, positive to turn to starboard, the volume of the pump in m3, positive to
   lift, the position of the pitch battery in m, positive to lower the nose. The two with a speed,
   m/s through the water, are those of a vehicle with a propeller, the others about depth and fin
   those of one that glides. Pump and battery are in
   force together, in place of a command about depth; the one that has not been commanded since the
   last of these is in the middle, at 0. What code in C commands is not known when a mission is
   compiled: a vehicle from before gliderFin or gliderPump refuses that command, not the link. */
void gliderDescend(GliderContext* context, double depth, double pitch);
void gliderAscend(GliderContext* context, double depth, double pitch);
void gliderDescendAt(GliderContext* context, double depth, double speed);
void gliderAscendAt(GliderContext* context, double depth, double speed);
void gliderHover(GliderContext* context, double depth);
void gliderSurface(GliderContext* context);
void gliderDriftFree(GliderContext* context);
void gliderSteer(GliderContext* context, double heading);
void gliderSteerTo(GliderContext* context, double latitude, double longitude);
void gliderFin(GliderContext* context, double angle);
void gliderPump(GliderContext* context, double volume);
void gliderBattery(GliderContext* context, double position);

#ifdef __cplusplus
}
#endif

#endif
