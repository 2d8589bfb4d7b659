// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/campaign/draw.h"

namespace glider::simulator {

/// Draws a fault of this kind: one sensor, the vehicle's or the hook's, at one or more times.
void addSensor(SensorFaultKind kind, Draw& draw, Faults& faults);

/// Draws a common cause for both pressures, the vehicle's and the CTD's: each is stuck and flickers
/// by as much, at one or more times.
void addBothPressures(Draw& draw, Faults& faults);

}  // namespace glider::simulator
