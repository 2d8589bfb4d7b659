// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#ifndef GLIDER_HOOKS_HOOKBEH_DEPTH_SOURCE_H
#define GLIDER_HOOKS_HOOKBEH_DEPTH_SOURCE_H

#include "hooks/hookbeh/cadence.h"
#include "hooks/hookbeh/hull.h"

/// What a cycle's reading of a depth is worth.
#ifdef __cplusplus
enum class HookDepthReading : uint8_t { Good, Missing, Jumped };
#else
typedef uint8_t HookDepthReading;
enum { kHookDepthReadingGood, kHookDepthReadingMissing, kHookDepthReadingJumped };
#endif

GLIDER_HOOKS_BEGIN

/// One sensor of the vehicle's depth, checked against what a vehicle can do.
typedef struct HookDepthSource {
  HookHull hull;
  HookCadence cadence;
  double depth_m;   ///< the newest good reading, m; while the sensor has been good for less than a
                    ///< minute, also a newer one that jumped; NaN before the first
  double age_s;     ///< of that reading; NaN before the first
  double same_s;    ///< how long the readings have been identical to the last bit; no two readings
                    ///< of a sensor that moves in the sea are
  double jumped_s;  ///< how long its readings have not continued the earlier good ones; each counts
                    ///< as a usual cycle, and for longer only where it is kept for longer than
                    ///< usual. Good readings in between reduce this by half of their own duration
  double good_s;
  HookDepthReading reading;
} HookDepthSource;

void hookDepthSourceInit(HookDepthSource* source, const HookHull* hull);
/// Takes in one cycle, `step_s` after the previous one. NaN: no reading.
void hookDepthSourceObserve(HookDepthSource* source, double depth_m, double step_s);
/// A sensor whose readings have been identical for this long is frozen, s: twice the usual time
/// between its new readings, and a cycle, from 16 s to 36 s.
double hookDepthSourcePatience(const HookDepthSource* source);

GLIDER_HOOKS_END

#endif
