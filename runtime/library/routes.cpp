// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The flightroutes of the library (ABI: runtime/abi/behaviour.h). A command equal to that in force
// changes nothing, so each gives its command in every tick: changes of live arguments then take
// effect automatically.

#include "runtime/library/library.h"

/// No heading commanded: the fin is centred.
extern "C" void gliderRouteNoheading(GliderContext* context, GliderBehaviourMemory*, uint32_t) {
  gliderDriftFree(context);
}

/// Towards the position at latitude, longitude, degrees.
extern "C" void gliderRouteNav(GliderContext* context, GliderBehaviourMemory*, uint32_t,
                               double latitude, double longitude) {
  gliderSteerTo(context, latitude, longitude);
}

/// On the heading `to`, rad clockwise from true north.
extern "C" void gliderRouteHeading(GliderContext* context, GliderBehaviourMemory*, uint32_t,
                                   double to) {
  gliderSteer(context, to);
}
