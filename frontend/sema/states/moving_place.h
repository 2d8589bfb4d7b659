// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/ast/ast.h"
#include "frontend/sema/names/scope.h"

namespace glider::frontend {

/// Reports each place given to a route that is computed from where the vehicle is: a route
/// evaluates its arguments again in each tick.
void warnOfMovingPlaces(const ast::Use& route, Scope& scope);

}  // namespace glider::frontend
