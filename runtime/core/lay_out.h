// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "runtime/abi/context_layout.h"

namespace glider::runtime {

/// Where the arrays of a context of `mission` stand. Out of line: it is called in several places.
GliderContextLayout layoutOf(const GliderMission& mission);

/// Makes a context of zeros in `memory`, which holds context_bytes of `mission`, and gives it its
/// arrays in the memory behind it.
GliderContext* layOut(void* memory, const GliderMission& mission);

}  // namespace glider::runtime
