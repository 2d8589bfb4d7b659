// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/ast/ast.h"

#include <string>

namespace glider::ast {

/// The canonical text of a mission, without comments: parsing it gives a file equal to `file`.
std::string print(const File& file);
/// One expression on one line, with no more parentheses than it needs.
std::string print(const Expr& expr);

}  // namespace glider::ast
