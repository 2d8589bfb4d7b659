// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/protocol/steps.h"

int32_t hookWholeSteps(double value, uint32_t per_unit, int32_t most) {
  const double steps = value * per_unit;
  if (!(steps > -most)) {
    return -most;
  }
  return steps < most ? (int32_t)(steps < 0 ? steps - 0.5 : steps + 0.5) : most;
}
