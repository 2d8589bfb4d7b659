// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/ast/ast.h"
#include "frontend/sema/names/scope.h"

#include <string>
#include <string_view>

namespace glider::frontend {

/// "flightprofile" or "flightroute".
std::string_view word(ir::BehaviourKind kind);

/// The behaviour that `use` names; null if there is none of that kind, which is reported, or if its
/// definition was refused.
BehaviourDeclaration* findBehaviour(const ast::Use& use, ir::BehaviourKind kind, Scope& scope);

/// A state that uses a behaviour.
struct User {
  ir::StateId state;
  const std::string& name;
};

/// Lowers a use of `declaration` into `activity`, whose range is already set, with arguments in the
/// scope's context.
void lowerUse(const ast::Use& use, BehaviourDeclaration& declaration, const User& user,
              ir::Activity& activity, Scope& scope);

}  // namespace glider::frontend
