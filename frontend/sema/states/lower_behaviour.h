// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/sema/names/scope.h"
#include "frontend/sema/states/lower_use.h"

#include <map>
#include <string>
#include <vector>

namespace glider::frontend {

/// The arguments for a behaviour's parameters where it is used.
struct BehaviourArguments {
  std::vector<Snippet> values;  ///< for Signature::slots
  std::vector<PathArgument> paths;
};

/// A flightprofile or flightroute written in the language: checked once, then lowered for each
/// state that uses it.
class BehaviourLowering {
 public:
  BehaviourLowering(BehaviourDeclaration& declaration, Scope& scope)
      : declaration_(declaration), scope_(scope) {}

  /// Reports the errors of the definition, whether it is used or not, and only once.
  void check();
  /// Lowers the body into `activity` for `user`.
  void use(ir::Activity& activity, const BehaviourArguments& arguments, const User& user);

 private:
  void checkMembers();
  void checkOnce(const ast::Member& member);
  void checkNothingBeside(const ast::Use& other);
  void checkChain();
  void checkOther(const ast::Use& other);
  void enterParameters();
  void giveArguments(const BehaviourArguments& arguments);
  void enterVariables();
  void useOther(const ast::Use& other, ir::Activity& activity, const User& user);
  void body(ir::Activity& activity, ir::StateId state, const std::string& prefix);
  [[nodiscard]] ir::VariableKind variableKind() const;
  [[nodiscard]] Context context(ir::StateId state);

  BehaviourDeclaration& declaration_;
  Scope& scope_;
  Names names_;
  std::map<size_t, const ast::Member*> seen_;  ///< by the index of the member's alternative
};

}  // namespace glider::frontend
