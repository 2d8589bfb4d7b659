// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "driver/sim_options.h"

namespace glider::driver {

/// Flies the run in the file `options.replay` instead of a world, and says what came of it; the
/// exit code.
int replayTrace(SimOptions options);

}  // namespace glider::driver
