// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/ast/ast.h"
#include "frontend/sema/names/scope.h"

#include <optional>
#include <string>
#include <vector>

namespace glider::frontend {

struct Value;

/// What receives the arguments.
struct Callee {
  const std::string& name;
  const Signature& signature;
  const ast::Name* declared = nullptr;  ///< where; null: nowhere in a mission
};

/// The lowered arguments: expressions for `Signature::slots`, and the paths, each in the order of
/// the parameters.
struct Arguments {
  std::vector<ir::ExprId> values;
  std::vector<PathArgument> paths;
};

/// Lowers arguments for `callee.signature.slots`, one expression each. A position is given as one
/// or as a latitude and a longitude, and may fill a latitude and the longitude after it. `where` is
/// the whole use. Empty, and reported, if they do not fit.
std::optional<Arguments> lowerArguments(const std::vector<ast::Argument>& arguments,
                                        const Callee& callee, const support::SourceRange& where,
                                        Scope& scope);

/// Whether a parameter and the next one are a latitude and a longitude: one position may be given
/// for both.
bool isLatitudeAndLongitude(const Signature& signature, size_t formal);

/// The argument that a parameter has if none is given: of a use at `where`, to be shown as `what`.
/// It is made from literals, `usual_pitch` and `usual_speed` alone, so it means the same at each
/// use. Empty, and reported, if it does not fit the parameter.
std::optional<Value> lowerUsual(const Signature::Formal& formal, const std::string& what,
                                const support::SourceRange& where, Scope& scope);

/// True, and reported (GL2196), if an argument is an angle where the vehicle takes a speed to go
/// to a depth, or a speed where it takes a pitch.
bool refuseOtherSlope(const std::vector<ast::Argument>& arguments, const Callee& callee,
                      Scope& scope);

}  // namespace glider::frontend
