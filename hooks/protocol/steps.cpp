// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/protocol/steps.h"

namespace glider::hooks {

int32_t wholeSteps(double value, uint32_t per_unit, int32_t most) {
  const double steps = value * per_unit;
  if (!(steps > -most)) {
    return -most;
  }
  return steps < most ? static_cast<int32_t>(steps < 0 ? steps - 0.5 : steps + 0.5) : most;
}

}  // namespace glider::hooks
