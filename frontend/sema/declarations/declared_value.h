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

/// The bounds of a value, in SI units or degrees; a missing bound is infinite.
struct Bounds {
  double lowest = -ir::Variable::kEndless;
  double highest = ir::Variable::kEndless;
};

/// The text of both ends and what is between them.
support::SourceRange whole(const ast::Range& range);

/// Whether an expression is the word `unknown`, which the mission uses for nothing else.
bool isUnknown(const ast::Expr& expr, Scope& scope);

/// Lowers the parts of a value's declaration other than its name.
class DeclaredValue {
 public:
  DeclaredValue(const ast::Name& name, const DeclaredType& type, Scope& scope)
      : name_(name), type_(type), scope_(scope) {}

  /// Its initial value, of its type. Empty, and reported, if it is not one, or if it counts
  /// something else than the range.
  std::optional<Value> start(const ast::Expr& expr);
  /// An unknown initial value; within `bounds` for whoever asks what it could be.
  Value unknown(const Bounds& bounds, const support::SourceRange& range);
  /// What the value counts, if it or an end of its range is written with such a unit.
  [[nodiscard]] const Scale& scale() const { return scale_; }
  /// A value of its type that must be known before the mission runs; `what` says what for. The
  /// second is a position's longitude. Leaves nothing lowered.
  std::optional<std::pair<double, double>> constant(const ast::Expr& expr, std::string_view what);
  std::optional<Bounds> bounds(const std::optional<ast::Range>& range);
  /// False, and reported, if the initial value `expr`, which is `value`, is out of bounds.
  bool inside(double value, const Bounds& bounds, const ast::Expr& expr, const ast::Range& range);

 private:
  const ast::Name& name_;
  const DeclaredType& type_;
  Scope& scope_;
  Scale scale_;
  const ast::Expr* scaled_ = nullptr;  ///< the part that is written with it
};

}  // namespace glider::frontend
