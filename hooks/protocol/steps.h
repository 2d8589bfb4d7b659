// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <stdint.h>

/// The real numbers of an instruction cross the vehicle's own line as text with six decimals, and
/// are kept in sensors of 4 or 8 bytes. So they are whole numbers of steps, coarse enough that each
/// survives both, however often, and even if a text is cut off instead of rounded: an angle in a
/// float32 is off by up to 0.02 steps and by 0.1 when its text is cut off, a depth of 1200 m by
/// 0.06, and a position in a float64 by 0.1.
namespace glider::hooks {

inline constexpr uint32_t kMetreSteps = 1000;     ///< of a millimetre
inline constexpr uint32_t kRadianSteps = 100000;  ///< 0.0006 degrees
inline constexpr uint32_t kMinuteSteps = 100000;  ///< of an arc minute: 2 cm

/// The most steps that a sensor of so many bytes carries: more than any depth, angle or position.
constexpr int32_t mostSteps(uint32_t bytes) {
  return bytes == 4 ? 3000000 : 2000000000;
}

/// `value` in whole steps, `per_unit` of which make its unit; the nearest in -most…most, -most for
/// NaN, so that an unknown value is outside every limit.
int32_t wholeSteps(double value, uint32_t per_unit, int32_t most = mostSteps(8));

}  // namespace glider::hooks
