// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/ast/ast.h"
#include "frontend/sema/scope.h"

namespace glider::frontend {

/// Enters what a file declares outside its states into `scope`: constants (worked out), external
/// behaviours, the names of parameters and variables, and of what is not compiled yet, each refused
/// once. `library`: the file is
/// no mission, so it has no states.
void declare(const ast::File& file, bool library, Scope& scope);

/// Lowers the parameters and variables of a mission, whose names `declare` entered. Parameters come
/// first, however they were written, then what they must satisfy together.
void declareValues(const ast::File& mission, Scope& scope);

/// Checks that the file is one mission: its `mission` line, the order of its head, that it has a
/// state.
void checkHead(const ast::File& file, Scope& scope);

}  // namespace glider::frontend
