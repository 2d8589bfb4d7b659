// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "runtime/abi/runtime.h"

/// Steps 1 and 2 of a tick (ir/README.md): from the vehicle's raw values to this tick's readings.
namespace glider::runtime {

/// Replaces the raw value of every sensor that the frame holds; its time is the context's mission
/// time.
void takeUpdates(GliderContext& context, const GliderUpdate* updates, uint32_t count);

/// Polls the SBC's own sensors, and does the same for those that have a new reading.
void pollSensors(GliderContext& context);

/// Makes each sensor's reading of this tick: SI units, NaN if it is unknown.
void refreshReadings(GliderContext& context);

/// A sensor's reading (its place in the mission's table) or a clock, by GliderSource.
double valueOf(const GliderContext& context, uint32_t source, uint32_t sensor);

}  // namespace glider::runtime
