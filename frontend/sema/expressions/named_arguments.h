// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/ast/ast.h"
#include "frontend/sema/expressions/lower_arguments.h"

#include <optional>
#include <vector>

namespace glider::frontend {

/// Arguments of which some are named, `yo(5 m, bottom = 20 m, …)`, in the order of the parameters;
/// those without a name come first. Empty, and reported, if a name is not a parameter's (GL2186) or
/// comes twice (GL2187), a parameter is left out (GL2188), or a name comes before none (GL2190).
std::optional<std::vector<ast::Argument>> inOrder(const std::vector<ast::Argument>& arguments,
                                                  const Callee& callee,
                                                  const support::SourceRange& where, Scope& scope);

/// True, and reported, if a parameter is named with `==` in place of `=`.
bool refuseEquals(const std::vector<ast::Argument>& arguments, const Callee& callee, Scope& scope);

/// True, and reported (GL2189), if an argument of a function of the language is named.
bool refuseNames(const ast::Invocation& node, Scope& scope);

}  // namespace glider::frontend
