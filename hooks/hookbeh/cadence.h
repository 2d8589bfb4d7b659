// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#ifndef GLIDER_HOOKS_HOOKBEH_CADENCE_H
#define GLIDER_HOOKS_HOOKBEH_CADENCE_H

#include "hooks/protocol/language.h"

GLIDER_HOOKS_BEGIN

/// Tells the new readings of a depth sensor from the cycles in which the sensor array keeps the
/// last one: the vehicle may read its pressure only every so many seconds (c_pressure_time), and
/// its cycles are not equally long. No two readings of a sensor that moves in the sea are identical
/// to the last bit.
typedef struct HookCadence {
  double last_m;
  double since_s;  ///< in a cycle with a new reading: since the one before, s; in any other: since
                   ///< the newest; NaN before there are any
  double usual_s;  ///< the usual time between two new readings, s. It follows slowly, so that a
                   ///< sensor that fails is still measured by what it was
  double learned;  ///< how many gaps it has learned from
  bool is_new;     ///< this cycle has a new reading
} HookCadence;

void hookCadenceInit(HookCadence* cadence);
/// Takes in one cycle, `step_s` after the previous one. NaN: no reading.
void hookCadenceObserve(HookCadence* cadence, double depth_m, double step_s);
/// It has learned `usual_s`; before that it assumes a reading in each cycle.
bool hookCadenceIsKnown(const HookCadence* cadence);

GLIDER_HOOKS_END

#endif
