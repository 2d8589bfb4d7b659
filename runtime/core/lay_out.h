// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "runtime/abi/glider_abi.h"

namespace glider::runtime {

/// Makes a context of zeros in `memory`, which holds context_bytes of `mission`, and gives it its
/// arrays in the memory behind it.
GliderContext* layOut(void* memory, const GliderMission& mission);

}  // namespace glider::runtime
