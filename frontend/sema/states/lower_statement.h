// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/ast/ast.h"
#include "frontend/sema/names/scope.h"

#include <vector>

namespace glider::frontend {

/// Lowers the statements of `do` and `entry`, in the scope's context.
class StatementLowering {
 public:
  explicit StatementLowering(Scope& scope) : scope_(scope) {}
  ir::BlockId lower(const std::vector<ast::Statement>& statements);

 private:
  void visit(const ast::Set& node, const ast::Statement& statement, ir::Block& block);
  void visit(const ast::If& node, const ast::Statement& statement, ir::Block& block);
  void visit(const ast::Log& node, const ast::Statement& statement, ir::Block& block);
  void visit(const ast::Command& node, const ast::Statement& statement, ir::Block& block);

  /// The variable that `name` refers to; null, and reported, if it cannot be set.
  Named* settable(const ast::Name& name);
  void refuseSet(const ast::Name& name);

  Scope& scope_;
};

}  // namespace glider::frontend
