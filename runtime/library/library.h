// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#ifndef GLIDER_RUNTIME_LIBRARY_LIBRARY_H
#define GLIDER_RUNTIME_LIBRARY_LIBRARY_H

/* The profiles and routes that come with the runtime, as `extern flightprofile` and `extern
   flightroute` bind to them, for missions written in C: missions in the language have
   missions/library/standard.mission, which does the same. Depths in m, pitches in rad (magnitudes),
   positions in degrees, headings in rad clockwise from north. */

#include "runtime/abi/behaviour.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Climbs and dives between two depths. An unknown depth makes it climb. */
void gliderProfileYo(GliderContext* context, GliderBehaviourMemory* memory, uint32_t phase,
                     double top, double bottom, double dive, double climb)
    GLIDER_SYMBOL("glider.profile.yo.length.length.angle.angle");
/* Finds the thermocline, where the temperature changes by `dtemp` K within `ddepth` m, and
   saw-tooths about it, as missions/library/standard.mission says. */
void gliderProfileThermotrackyo(GliderContext* context, GliderBehaviourMemory* memory,
                                uint32_t phase, double top, double bottom, double dive,
                                double climb, double dtemp, double ddepth)
    GLIDER_SYMBOL("glider.profile.thermotrackyo.length.length.angle.angle.temperature.length");
/* Climbs to the surface and stays there. */
void gliderProfileSurfaced(GliderContext* context, GliderBehaviourMemory* memory, uint32_t phase)
    GLIDER_SYMBOL("glider.profile.surfaced");

void gliderRouteNoheading(GliderContext* context, GliderBehaviourMemory* memory, uint32_t phase)
    GLIDER_SYMBOL("glider.route.noheading");
void gliderRouteNav(GliderContext* context, GliderBehaviourMemory* memory, uint32_t phase,
                    double latitude, double longitude)
    GLIDER_SYMBOL("glider.route.nav.latitude.longitude");
void gliderRouteHeading(GliderContext* context, GliderBehaviourMemory* memory, uint32_t phase,
                        double to) GLIDER_SYMBOL("glider.route.heading.angle");

#ifdef __cplusplus
}
#endif

#endif
