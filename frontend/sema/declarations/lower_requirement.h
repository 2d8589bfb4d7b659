// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/ast/ast.h"
#include "frontend/sema/names/scope.h"

namespace glider::frontend {

/// Enters the places, so that an error in a case can name them.
void declareRequired(const ast::File& file, Scope& scope);
/// Lowers the mission's requirements after everything else, so that sensors that only they read
/// come last.
void lowerRequirements(const ast::File& file, Scope& scope);

}  // namespace glider::frontend
