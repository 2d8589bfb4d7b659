// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#ifndef GLIDER_HOOKS_PROTOCOL_STEPS_H
#define GLIDER_HOOKS_PROTOCOL_STEPS_H

#include "hooks/protocol/language.h"

/// The real numbers of an instruction cross the vehicle's own line as text with six decimals, and
/// are kept in sensors of 4 or 8 bytes. So they are whole numbers of steps, coarse enough that each
/// survives both, however often, and even if a text is cut off instead of rounded: an angle in a
/// float32 is off by up to 0.02 steps and by 0.1 when its text is cut off, a depth of 1200 m by
/// 0.06, and a position in a float64 by 0.1.
GLIDER_HOOKS_BEGIN

enum {
  kHookMetreSteps = 1000,     ///< of a millimetre
  kHookRadianSteps = 100000,  ///< 0.0006 degrees
  kHookMinuteSteps = 100000   ///< of an arc minute: 2 cm
};

/// The most steps that a sensor of 4 or of 8 bytes carries: more than any depth, angle or position.
enum { kHookMostStepsOf4 = 3000000, kHookMostStepsOf8 = 2000000000 };

/// `value` in whole steps, `per_unit` of which make its unit; the nearest in -most…most, -most for
/// NaN, so that an unknown value is outside every limit.
int32_t hookWholeSteps(double value, uint32_t per_unit, int32_t most);

GLIDER_HOOKS_END

#endif
