// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "driver/sim_options.h"

namespace glider::driver {

/// Replays the trace in the file `options.replay` instead of a scenario, and reports the result;
/// returns the exit code.
int replayTrace(SimOptions options);

}  // namespace glider::driver
