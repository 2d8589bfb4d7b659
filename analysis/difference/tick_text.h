// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/eval/interpreter.h"

#include <string>
#include <vector>

namespace glider::analysis {

/// What a tick did, as both versions of a mission call it: its transition and its commands.
/// `names`: of the states, by number.
std::string tickText(const ir::Mission& mission, const ir::TickResult& result, ir::StateId before,
                     const std::vector<std::string>& names);

/// The known readings of all sensors after a tick: "depth = 12 m".
std::vector<std::string> readingsText(const ir::Mission& mission,
                                      const ir::Interpreter& interpreter);

}  // namespace glider::analysis
