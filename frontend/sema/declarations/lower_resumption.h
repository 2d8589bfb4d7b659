// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/ast/ast.h"
#include "frontend/sema/names/scope.h"

namespace glider::frontend {

/// The mission's `resume within`, if it has one.
void lowerResumption(const ast::File& file, Scope& scope);

}  // namespace glider::frontend
