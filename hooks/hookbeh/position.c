// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/hookbeh/position.h"

#include "hooks/protocol/numbers.h"

static const double kMetresPerDegree = 111120;
static const double kRadPerDegree = 0.017453292519943295;

bool hookIsPositionKnown(HookPosition at) {
  return hookMagnitude(at.latitude_ddmm) <= 9000 && hookMagnitude(at.longitude_ddmm) <= 18000;
}

static double degrees(double ddmm) {
  const int32_t whole = (int32_t)(ddmm / 100);
  return whole + (ddmm - 100.0 * whole) / 60;
}

/// The cosine up to a right angle, within 0.001; there is no math library on board.
static double cosine(double rad) {
  const double square = rad * rad;
  return hookAtLeast(1 - square / 2 + square * square / 24 - square * square * square / 720, 0);
}

double hookDistanceBetween(HookPosition a, HookPosition b) {
  if (!hookIsPositionKnown(a) || !hookIsPositionKnown(b)) {
    return 0;
  }
  const double latitude = degrees(a.latitude_ddmm);
  const double north = hookMagnitude(latitude - degrees(b.latitude_ddmm));
  const double east = hookMagnitude(degrees(a.longitude_ddmm) - degrees(b.longitude_ddmm));
  const double shorter = hookAtMost(360 - east, east);  // across the date line
  return kMetresPerDegree * hookAtLeast(shorter * cosine(latitude * kRadPerDegree), north);
}
