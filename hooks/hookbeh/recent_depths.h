// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#ifndef GLIDER_HOOKS_HOOKBEH_RECENT_DEPTHS_H
#define GLIDER_HOOKS_HOOKBEH_RECENT_DEPTHS_H

#include "hooks/protocol/language.h"

GLIDER_HOOKS_BEGIN

enum { kHookRecentDepths = 10 };

/// The depths of the last 20 s, for comparison with the delayed readings of another sensor.
typedef struct HookRecentDepths {
  struct {
    double depth_m;
    double age_s;
  } samples[kHookRecentDepths];
  uint8_t next;
} HookRecentDepths;

void hookRecentDepthsInit(HookRecentDepths* recent);
/// Takes in one cycle, `step_s` after the previous one. NaN: there was no depth.
void hookRecentDepthsObserve(HookRecentDepths* recent, double depth_m, double step_s);
/// How far `depth_m` is outside the depths of these seconds, m; 0 if within them, NaN if there are
/// none.
double hookRecentDepthsDistanceTo(const HookRecentDepths* recent, double depth_m);

GLIDER_HOOKS_END

#endif
