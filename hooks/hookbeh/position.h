// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#ifndef GLIDER_HOOKS_HOOKBEH_POSITION_H
#define GLIDER_HOOKS_HOOKBEH_POSITION_H

#include "hooks/protocol/language.h"

GLIDER_HOOKS_BEGIN

/// A position as the vehicle's sensors give it, in ddmm.mmmm; NaN for unknown.
typedef struct HookPosition {
  double latitude_ddmm;
  double longitude_ddmm;
} HookPosition;

/// False if it is unknown or not on Earth.
bool hookIsPositionKnown(HookPosition at);
/// How far apart two positions are, m: the greater of the distances along the meridian and along
/// the parallel, so at most three tenths too little and never too much. 0 if either is unknown or
/// not on Earth: an unknown position counts as near.
double hookDistanceBetween(HookPosition a, HookPosition b);

GLIDER_HOOKS_END

#endif
