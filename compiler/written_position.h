// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/ast/ast.h"

#include <optional>
#include <string>

namespace glider::compiler {

/// "39 10.500 N 73 49.800 W": a position that is written with its numbers in the one form that
/// pages show; empty for anything else.
std::optional<std::string> positionText(const ast::Expr& written);
/// The same of a latitude and a longitude: `3910.5, -7349.8`.
std::optional<std::string> positionText(const ast::Expr& latitude, const ast::Expr& longitude);

}  // namespace glider::compiler
