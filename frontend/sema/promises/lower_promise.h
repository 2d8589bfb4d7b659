// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/ast/ast.h"
#include "frontend/sema/names/scope.h"
#include "frontend/sema/promises/pattern.h"

#include <optional>
#include <string_view>

namespace glider::frontend {

/// The value of `expr`, which must be known when the mission is compiled; empty, and reported, if
/// it is not. `what` names it: "the time of `within`".
std::optional<double> promisedNumber(const ast::Expr& expr, const ir::Type& type,
                                     const std::string& what, Scope& scope);
/// A time above 0; `word` is what stands before it.
std::optional<PromiseTime> promisedTime(const ast::Expr& expr, std::string_view word, Scope& scope);

/// Lowers the patterns of requirements: to a requirement that has no monitor where one condition
/// expresses it, otherwise to a monitor. Each returns false, and reports, if something is wrong.
class PromiseLowering {
 public:
  PromiseLowering(const ast::Requirement& node, Scope& scope, ir::Requirement& result)
      : node_(node), scope_(scope), result_(result) {}

  /// Of a condition that combines states or places, or of a place.
  bool lower(const ast::AlwaysPromise& promise);
  bool lower(const ast::VisitPromise& promise);
  bool lower(const ast::PatrolPromise& promise);
  bool lower(const ast::CountPromise& promise);
  bool lower(const ast::NeverPromise& promise);
  bool lower(const ast::ReactionPromise& promise);
  bool lower(const ast::HoldPromise& promise);

 private:
  /// Only a sequence may name a place twice, with another between.
  std::optional<std::vector<PromisedPlace>> places(const std::vector<ast::Expr>& exprs,
                                                   ast::Manner manner);
  bool finish(const std::function<void(Pattern&)>& write);
  /// The requirement that this is never true.
  bool neverTrue(ir::ExprId condition);
  /// Whether neither a scope nor an end concerns it.
  [[nodiscard]] bool isPlain() const { return !node_.scope && !node_.or_exit; }

  const ast::Requirement& node_;
  Scope& scope_;
  ir::Requirement& result_;
};

}  // namespace glider::frontend
