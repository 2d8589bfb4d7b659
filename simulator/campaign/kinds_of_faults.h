// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/campaign/promises.h"
#include "simulator/faults/faults.h"

#include <vector>

namespace glider::simulator {

/// The kind to which a fault of a sensor belongs.
FaultKind kindOf(const SensorFault& fault);

/// The kinds of faults that a scenario itself contains.
std::vector<FaultKind> kindsOf(const Faults& faults);

}  // namespace glider::simulator
