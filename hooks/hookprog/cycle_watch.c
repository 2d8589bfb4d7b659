// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/hookprog/cycle_watch.h"

enum {
  kCircle = 0xFFFFFF,
  kMostLost = 8  // lost reports between two that arrive in order
};

bool hookprogCycleIsNext(HookprogCycleWatch* watch, uint32_t cycle) {
  const uint32_t ahead = (cycle - watch->newest) & kCircle;
  const uint32_t after_earlier = (cycle - watch->earlier) & kCircle;
  const bool later = ahead != 0 && ahead <= kCircle / 2;
  const bool restarted = watch->was_earlier && after_earlier != 0 && after_earlier <= kMostLost;
  watch->was_earlier = watch->known && !later && !restarted;
  watch->earlier = cycle;
  watch->newest = watch->was_earlier ? watch->newest : cycle;
  watch->known = true;
  return !watch->was_earlier;
}
