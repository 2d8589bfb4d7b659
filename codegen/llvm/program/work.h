// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"

#include <cstddef>
#include <cstdint>

namespace glider::codegen {

// The amount of code to generate, in expressions and statements; a function counts one.

/// The ticks of a state's profile.
size_t workOfProfileTick(const ir::Mission& mission, uint32_t state);
/// Everything else of a state.
size_t workOfState(const ir::Mission& mission, uint32_t state);

}  // namespace glider::codegen
