// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/ast/ast.h"
#include "frontend/sema/names/scope.h"

namespace glider::frontend {

/// The mission's line `nap at most`, if it has one. To be called when its `resume within` is known.
void lowerNap(const ast::File& file, Scope& scope);

}  // namespace glider::frontend
