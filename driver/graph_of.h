// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "driver/compilation.h"
#include "report/graph/graph.h"

namespace glider::driver {

/// The state machine of a compilation's mission, with its texts as the pilot wrote them.
report::Graph graphOf(const Compilation& compilation);

}  // namespace glider::driver
