// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#ifndef GLIDER_RUNTIME_C_VEHICLE_H
#define GLIDER_RUNTIME_C_VEHICLE_H

/* The vehicle that a mission in C is for. libglider.a brings that of platform `slocum`; a mission
   for another defines its own: `glidercc platform NAME --header` writes a header that does so where
   GLIDER_DEFINE_VEHICLE is defined; the others define GLIDER_SENSORS_HEADER as that header's name
   before they include glider.h. */

#include "runtime/abi/glider_abi.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct GliderVehicle {
  const GliderDictionary* dictionary;
  const GliderSensorInfo* sensors; /* by number, dictionary->count of them */
} GliderVehicle;

extern const GliderVehicle gliderVehicle;

#ifdef __cplusplus
}
#endif

#endif
