// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/ast/ast.h"
#include "frontend/sema/lower_expr.h"
#include "frontend/sema/scope.h"

#include <map>
#include <string>
#include <vector>

namespace glider::frontend {

/// Lowers one state. Names of states, constants and behaviours stand in the scope before.
class StateLowering {
 public:
  StateLowering(const ast::State& state, Scope& scope) : state_(state), scope_(scope) {}
  ir::State run();

 private:
  void visit(const ast::RouteMember& node, const ast::Member& member);
  void visit(const ast::ProfileMember& node, const ast::Member& member);
  void visit(const ast::SensorsMember& node, const ast::Member& member);
  void visit(const ast::Var& node, const ast::Member& member);
  void visit(const ast::EntryMember& node, const ast::Member& member);
  void visit(const ast::EventsMember& node, const ast::Member& member);

  /// False, and reported, if the state has a member of this kind already.
  bool first(const ast::Member& member);
  void defaults();

  // Behaviours (lower_use.cpp).
  ir::Activity activity(const ast::Use& use, ir::BehaviourKind kind);
  std::vector<ir::ExprId> arguments(const ast::Use& use, const BehaviourDeclaration& declaration);
  bool wrongCount(const ast::Use& use, const BehaviourDeclaration& declaration, size_t filled);
  [[nodiscard]] bool isPosition(const ast::Expr& expr) const;

  void lowerItem(const ast::SensorItem& item);
  void setPeriod(const ast::Expr& every, size_t from);
  void lowerCase(const ast::Case& node);
  void lowerTarget(const ast::Case& node, ir::Case& lowered);
  void warnOfUnlisted(const std::vector<SensorRead>& reads);

  const ast::State& state_;
  Scope& scope_;
  ir::State result_;
  std::map<size_t, const ast::Member*> seen_;       ///< by the index of the member's alternative
  std::map<std::string, const ast::Name*> listed_;  ///< by the vehicle's name, or the clock's
  std::map<std::string, bool> warned_;
};

}  // namespace glider::frontend
