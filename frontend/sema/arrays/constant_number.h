// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/ast/ast.h"
#include "frontend/sema/names/scope.h"

#include <optional>
#include <string>

namespace glider::frontend {

/// The value of a plain number that must be known when the mission is compiled; NaN if it is
/// unknown. Empty, and reported, if it is not a plain number or not constant; `what` says what for.
/// Leaves nothing lowered.
std::optional<double> constantNumber(const ast::Expr& expr, const std::string& what, Scope& scope);

}  // namespace glider::frontend
