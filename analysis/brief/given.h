// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "compiler/compilation.h"

#include <functional>
#include <span>
#include <vector>

namespace glider::analysis {

/// What a use of a profile or route gives for one of its parameters.
struct Given {
  std::vector<const ast::Formal*> formals;  ///< two: one position for a latitude and a longitude
  std::vector<const ast::Expr*> values;     ///< two: a latitude and a longitude for one position
};

/// `arguments` by what they are for, in the order of the parameters; those that are left out have
/// no entry. The arguments fit `formals`; `is_position` says whether a value is a whole position.
std::vector<Given> givenTo(std::span<const ast::Formal> formals,
                           std::span<const ast::Argument> arguments,
                           const std::function<bool(const ast::Expr&)>& is_position);

}  // namespace glider::analysis
