// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/hookbeh/recent_depths.h"

#include "hooks/protocol/numbers.h"

static const double kKeptSecs = 20;

void hookRecentDepthsInit(HookRecentDepths* recent) {
  for (int i = 0; i < kHookRecentDepths; ++i) {
    recent->samples[i].depth_m = hookUnknown();
    recent->samples[i].age_s = 0;
  }
  recent->next = 0;
}

void hookRecentDepthsObserve(HookRecentDepths* recent, double depth_m, double step_s) {
  for (int i = 0; i < kHookRecentDepths; ++i) {
    recent->samples[i].age_s += step_s;
  }
  recent->samples[recent->next].depth_m = depth_m;
  recent->samples[recent->next].age_s = 0;
  recent->next = (uint8_t)((recent->next + 1) % kHookRecentDepths);
}

double hookRecentDepthsDistanceTo(const HookRecentDepths* recent, double depth_m) {
  double highest = hookUnknown();
  double lowest = hookUnknown();
  for (int i = 0; i < kHookRecentDepths; ++i) {
    const double sample_m = recent->samples[i].depth_m;
    if (!hookIsFinite(sample_m) || recent->samples[i].age_s > kKeptSecs) {
      continue;
    }
    highest = hookAtMost(highest, sample_m);  // or the first
    lowest = hookAtLeast(lowest, sample_m);
  }
  return hookAtLeast(0, hookAtLeast(highest - depth_m, depth_m - lowest));
}
