// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/ast/ast.h"

#include <string>
#include <vector>

namespace glider::ast {

/// "(5 m, 10 m of depth)"
std::string printArguments(const std::vector<Argument>& arguments);

}  // namespace glider::ast
