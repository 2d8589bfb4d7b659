// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "compiler/compilation.h"
#include "support/trace/trace.h"

namespace glider::flights {

/// Adds to `trace` a column for each value of the mission's `log` statements, in SI units, degrees
/// or the unit of the sensor, and to its facts what they are. A value is in the row of the control
/// cycle in which the vehicle received it, or the next one; of several in one cycle, the last.
/// Statements with the same text and unit share a column.
void addLoggedValues(const compiler::Optimised& mission, support::Trace& trace);

}  // namespace glider::flights
