// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/ast/ast.h"
#include "frontend/sema/names/scope.h"

namespace glider::frontend {

/// Enters what a file declares outside its states into `scope`: constants (worked out), external
/// behaviours, the names of parameters and variables, and of what is not compiled yet, each refused
/// once. `library`: of a file that is no mission, only what may be imported.
void declare(const ast::File& file, bool library, Scope& scope);

/// Lowers the parameters and variables of a mission, whose names `declare` entered. Parameters come
/// first, however they were written, then what they must satisfy together.
void declareValues(const ast::File& mission, Scope& scope);

/// Whether a library may hold `item`.
bool mayBeImported(const ast::Item& item);
/// Refuses what a library may not hold, and imports that do not come first.
void checkImported(const ast::File& file, Scope& scope);

/// Checks that the file is one mission: its `mission` line, the order of its head, that it has a
/// state.
void checkHead(const ast::File& file, Scope& scope);

}  // namespace glider::frontend
