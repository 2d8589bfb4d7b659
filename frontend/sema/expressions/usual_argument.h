// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/sema/expressions/lower_arguments.h"
#include "frontend/sema/expressions/lower_expr.h"

namespace glider::frontend {

/// The argument that a parameter has if none is given: of a use at `where`, to be shown as `what`.
/// It is made from literals, `usual_pitch` and `usual_speed` alone, so it means the same at each
/// use. Empty, and reported, if it does not fit the parameter.
std::optional<Value> lowerUsual(const Signature::Formal& formal, const std::string& what,
                                const support::SourceRange& where, Scope& scope);

/// True, and reported (GL2196), if an argument is an angle where the vehicle is told a speed to go
/// to a depth, or a speed where it is told a pitch.
bool refuseOtherSlope(const std::vector<ast::Argument>& arguments, const Callee& callee,
                      Scope& scope);

}  // namespace glider::frontend
