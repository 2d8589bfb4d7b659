// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/ast/ast.h"
#include "frontend/sema/names/scope.h"

namespace glider::frontend {

/// Lowers the mission's requirements after everything else, so that sensors that only they read
/// come last.
void lowerRequirements(const ast::File& file, Scope& scope);

}  // namespace glider::frontend
