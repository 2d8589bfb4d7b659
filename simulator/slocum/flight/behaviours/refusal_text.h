// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/hookbeh/hookbeh.h"

#include <string>

namespace glider::simulator {

/// Why hookbeh refused the instruction in `in`, with the limit in effect, which `args` holds, and
/// what was commanded: "max_depth 30 m refuses a dive to 45 m".
std::string refusalText(hooks::HookAnswer answer, const hooks::HookbehInputs& in,
                        const hooks::HookbehArgs& args);

}  // namespace glider::simulator
