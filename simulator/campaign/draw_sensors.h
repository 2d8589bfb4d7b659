// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/campaign/draw.h"

namespace glider::simulator {

/// A sensor says what is not true, of the vehicle's own or of the hook's.
bool isSensorKind(FaultKind kind);
/// Draws a fault of such a kind: one sensor, in one or more times.
void addSensor(FaultKind kind, Draw& draw, Faults& faults);

}  // namespace glider::simulator
