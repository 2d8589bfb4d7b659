// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#ifndef GLIDER_HOOKS_HOOKPROG_CYCLE_WATCH_H
#define GLIDER_HOOKS_HOOKPROG_CYCLE_WATCH_H

#include "hooks/protocol/language.h"

GLIDER_HOOKS_BEGIN

/// Checks whether a report of the flight controller is from a later cycle than those before it. A
/// report from an earlier cycle is a repetition; two in order show that the vehicle has restarted
/// its count. It begins with all bytes zero.
typedef struct HookprogCycleWatch {
  uint32_t newest GLIDER_IS(0);
  uint32_t earlier GLIDER_IS(0);  ///< of the newest report, when `was_earlier`
  bool known GLIDER_IS(false);
  bool was_earlier GLIDER_IS(false);
} HookprogCycleWatch;

/// `cycle` wraps at 2^24.
bool hookprogCycleIsNext(HookprogCycleWatch* watch, uint32_t cycle);

GLIDER_HOOKS_END

#endif
