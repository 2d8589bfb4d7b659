// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/sema/scope.h"

#include <map>
#include <string>
#include <vector>

namespace glider::frontend {

/// A flightprofile or flightroute written in the language: checked once, then lowered anew for each
/// state that uses it.
class BehaviourLowering {
 public:
  BehaviourLowering(BehaviourDeclaration& declaration, Scope& scope)
      : declaration_(declaration), scope_(scope) {}

  /// Reports what is wrong with the definition, used or not, and that once.
  void check();
  /// Lowers the body into `activity` for `state`, called `state_name`, with what stands for the
  /// parameters' slots.
  void use(ir::Activity& activity, const std::vector<Snippet>& arguments, ir::StateId state,
           const std::string& state_name);

 private:
  void checkMembers();
  void checkOnce(const ast::Member& member);
  void enterParameters();
  void giveArguments(const std::vector<Snippet>& arguments);
  void enterVariables();
  void body(ir::Activity& activity, ir::StateId state, const std::string& prefix);
  [[nodiscard]] ir::VariableKind variableKind() const;
  [[nodiscard]] Context context(ir::StateId state);

  BehaviourDeclaration& declaration_;
  Scope& scope_;
  Names names_;
  std::map<size_t, const ast::Member*> seen_;  ///< by the index of the member's alternative
};

}  // namespace glider::frontend
