// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/ast/ast.h"
#include "frontend/sema/names/scope.h"

namespace glider::frontend {

/// Lowers the mission's `assume` lines.
void lowerAssumptions(const ast::File& file, Scope& scope);

}  // namespace glider::frontend
