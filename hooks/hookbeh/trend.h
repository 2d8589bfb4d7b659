// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#ifndef GLIDER_HOOKS_HOOKBEH_TREND_H
#define GLIDER_HOOKS_HOOKBEH_TREND_H

#include "hooks/protocol/language.h"

GLIDER_HOOKS_BEGIN

enum { kHookTrendReadings = 12 };

typedef struct HookTrendReading {
  double at_s;
  double depth_m;
} HookTrendReading;

/// The straight line through the newest readings of a depth: tells a vehicle that moves in swell
/// from a sensor that wavers about one value.
typedef struct HookTrend {
  HookTrendReading readings[kHookTrendReadings];
  uint8_t next;
  uint8_t count;
} HookTrend;

void hookTrendInit(HookTrend* trend);
void hookTrendClear(HookTrend* trend);
/// A reading, `gap_s` after the previous one.
void hookTrendAdd(HookTrend* trend, double depth_m, double gap_s);
/// How far the depth has moved along the line, m, positive downwards: over the fewest of the
/// newest readings that show it beyond doubt; 0 if none do. `roughness_m`: how far readings
/// usually are off the line of their neighbours. `fastest_mps`: no vehicle moves faster.
double hookTrendMoved(const HookTrend* trend, double roughness_m, double fastest_mps);

GLIDER_HOOKS_END

#endif
