// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/result.h"
#include "support/trace/trace.h"

#include <string>
#include <vector>

namespace glider::report {

/// The time of `log` at which time 0 of `flight` is drawn: both leave the surface for the first
/// time at the same time. `name`: of the flight, for messages. GL9367 if one of them never does.
support::Result<double> shiftBeside(const support::Trace& log, const support::Trace& flight,
                                    const std::string& name);

/// Adds the simulated `flight` to `log` as columns `sim_depth`, `sim_x` and `sim_y`: its time is
/// shifted by `shift_s`, its track begins to dive where the log's does.
void addBeside(support::Trace& log, const support::Trace& flight, double shift_s,
               const std::string& name);

}  // namespace glider::report
