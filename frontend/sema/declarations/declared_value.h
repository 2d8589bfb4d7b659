// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/ast/ast.h"
#include "frontend/sema/expressions/lower_expr.h"
#include "frontend/sema/names/scope.h"

#include <optional>
#include <string_view>
#include <utility>

namespace glider::frontend {

/// Between what a value lies, in SI units or degrees; what is not written is endless.
struct Bounds {
  double lowest = -ir::Variable::kEndless;
  double highest = ir::Variable::kEndless;
};

/// Lowers what the declaration of a value holds beside its name.
class DeclaredValue {
 public:
  DeclaredValue(const ast::Name& name, const DeclaredType& type, Scope& scope)
      : name_(name), type_(type), scope_(scope) {}

  /// What it starts with, of its type.
  std::optional<Value> start(const ast::Expr& expr);
  /// A value of its type that must be known before the mission runs; `what` it is for. The second
  /// is a position's longitude. Lowers nothing.
  std::optional<std::pair<double, double>> constant(const ast::Expr& expr, std::string_view what);
  std::optional<Bounds> bounds(const std::optional<ast::Range>& range);
  /// False, and reported, if the start `expr`, which is `value`, lies outside.
  bool inside(double value, const Bounds& bounds, const ast::Expr& expr, const ast::Range& range);

 private:
  const ast::Name& name_;
  const DeclaredType& type_;
  Scope& scope_;
};

}  // namespace glider::frontend
