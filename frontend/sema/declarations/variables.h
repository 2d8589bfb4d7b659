// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/ast/ast.h"
#include "frontend/sema/declarations/declared_value.h"
#include "frontend/sema/names/scope.h"

#include <string>

namespace glider::frontend {

/// The owner of a variable.
struct VariableOwner {
  ir::VariableKind kind = ir::VariableKind::Mission;
  ir::StateId state;   ///< none for the mission
  std::string prefix;  ///< of its name in the IR: "leg.", "search.profile."
};

/// Enters a name that is visible from the scope's context into `names`. Null, and reported, if it
/// cannot be used.
Named* enterName(const ast::Name& name, NamedKind kind, Names& names, Scope& scope);

/// The variable of a parameter whose value, within `bounds`, is given elsewhere.
void makeParameter(Named& named, ir::VariableKind kind, ir::StateId state, const std::string& name,
                   Scope& scope, const Bounds& bounds);

/// Lowers a `var` whose name was entered into `names`, in the scope's context.
void lowerVariable(const ast::Var& node, const VariableOwner& owner, Names& names, Scope& scope);

/// The truth value that `done` sets.
ir::VariableId makeDone(const VariableOwner& owner, const support::SourceRange& range,
                        Scope& scope);

/// Lowers a `param` of the mission whose name was entered.
void lowerMissionParameter(const ast::Param& node, Scope& scope);
/// Lowers its `where`, once all parameters are lowered.
void lowerMissionCondition(const ast::Param& node, Scope& scope);

/// Warns about names that are never read, and about variables that are never set.
void warnOfUnused(const Names& names, Scope& scope);

}  // namespace glider::frontend
