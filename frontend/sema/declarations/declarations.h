// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/ast/ast.h"
#include "frontend/sema/names/scope.h"

namespace glider::frontend {

/// Enters what a file declares outside its states into `scope`: constants (evaluated), external
/// behaviours, and the names of parameters and variables. What is not compiled yet is refused once.
/// `library`: for a file that is not a mission, only what may be imported.
void declare(const ast::File& file, bool library, Scope& scope);

/// Lowers the parameters and variables of a mission, whose names `declare` has entered. Parameters
/// come first, in any order of the text, then the conditions that they must satisfy together.
void declareValues(const ast::File& mission, Scope& scope);

/// Whether a library may contain `item`.
bool mayBeImported(const ast::Item& item);
/// Refuses what a library may not contain, and imports that do not come first.
void checkImported(const ast::File& file, Scope& scope);

/// Checks that the file is one mission: its `mission` line, the order of its head, at least one
/// state.
void checkHead(const ast::File& file, Scope& scope);

}  // namespace glider::frontend
