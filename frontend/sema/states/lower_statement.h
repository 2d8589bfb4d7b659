// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/ast/ast.h"
#include "frontend/sema/expressions/lower_expr.h"
#include "frontend/sema/names/scope.h"

#include <optional>
#include <vector>

namespace glider::frontend {

/// A statement of the text at `range`.
ir::Statement statementOf(ir::StatementKind kind, const support::SourceRange& range);

/// What the logs keep of the text of a `log`, bytes; the vehicle's has its values in there too
/// (kMostNoteBytes of hooks/protocol/messages.h, kNameBytes of runtime/log/mission_log.h).
inline constexpr size_t kNoteBytes = 60;

/// Lowers the statements of `do` and `entry`, in the scope's context.
class StatementLowering {
 public:
  explicit StatementLowering(Scope& scope) : scope_(scope) {}
  ir::BlockId lower(const std::vector<ast::Statement>& statements);

 private:
  void lowerInto(ir::Block& block, const std::vector<ast::Statement>& statements);
  void visit(const ast::Set& node, const ast::Statement& statement, ir::Block& block);
  void visit(const ast::If& node, const ast::Statement& statement, ir::Block& block);
  /// Lowers the body once for each pass (lower_loop.cpp).
  void visit(const ast::For& node, const ast::Statement& statement, ir::Block& block);
  void checkLength(const std::string& text, const ast::Statement& statement);
  void visit(const ast::Log& node, const ast::Statement& statement, ir::Block& block);
  void visit(const ast::Command& node, const ast::Statement& statement, ir::Block& block);

  // Loops (lower_loop.cpp).
  std::optional<double> bound(const ast::Expr& expr);
  void passes(const ast::For& node, double first, double last, ir::Block& block);

  // Assignments (lower_set.cpp).
  /// True, and reported, for an array without an index, and for another variable with one.
  bool misindexed(const Named& named, const ast::Set& node);
  /// Sets the element of `array` that `index` says; nothing where there is none.
  void setElement(const Array& array, const ElementIndex& index, const Value& value,
                  const support::SourceRange& range, ir::Block& block);
  ir::BlockId chooseElement(const Array& array, size_t from, ir::ExprId number, const Value& value,
                            const support::SourceRange& range);
  /// `push(temps, temp)`: the others move back by one, and the last one is forgotten.
  void push(const ast::Invocation& call, const ast::Statement& statement, ir::Block& block);
  [[nodiscard]] bool readsElement(const Value& value, const Array& array) const;
  void moveBack(const Array& array, const Value& value, const support::SourceRange& range,
                ir::Block& block);

  /// The variable that `name` refers to; null, and reported, if it cannot be set.
  Named* settable(const ast::Name& name);
  void refuseSet(const ast::Name& name);

  Scope& scope_;
};

}  // namespace glider::frontend
