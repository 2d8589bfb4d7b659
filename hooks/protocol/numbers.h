// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#ifndef GLIDER_HOOKS_PROTOCOL_NUMBERS_H
#define GLIDER_HOOKS_PROTOCOL_NUMBERS_H

#include "hooks/protocol/language.h"

/// The few functions of a math library that are needed on board.
GLIDER_HOOKS_BEGIN

/// A value that is not known: a quiet NaN.
GLIDER_INLINE double hookUnknown(void) {
#ifdef __GNUC__
  return __builtin_nan("");
#else
  union {
    uint64_t bits;
    double value;
  } quiet = {UINT64_C(0x7FF8000000000000)};
  return quiet.value;
#endif
}

/// False for NaN and the infinities.
GLIDER_INLINE bool hookIsFinite(double value) {
  return value - value == 0;
}

GLIDER_INLINE double hookMagnitude(double value) {
#ifdef __GNUC__
  return __builtin_fabs(value);
#else
  return value < 0 ? -value : value;
#endif
}

/// The greater and the lesser of two; the bound where `value` is NaN.
GLIDER_INLINE double hookAtLeast(double value, double least) {
  return value > least ? value : least;
}
GLIDER_INLINE double hookAtMost(double value, double most) {
  return value < most ? value : most;
}

/// NaN where `value` is NaN.
GLIDER_INLINE double hookBetween(double value, double lowest, double highest) {
  return value < lowest ? lowest : value > highest ? highest : value;
}

/// The value that a 4-byte sensor would keep.
GLIDER_INLINE double hookAsFloat32(double value) {
  return (double)(float)value;
}

/// Whether `value` is a whole number from `lowest` to `highest`, which is then in `whole`.
GLIDER_INLINE bool hookIsWhole(double value, uint32_t lowest, uint32_t highest, uint32_t* whole) {
  if (!(value >= lowest && value <= highest)) {
    return false;
  }
  *whole = (uint32_t)value;
  return (double)*whole == value;
}

GLIDER_HOOKS_END

#endif
