// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/ast/ast.h"
#include "frontend/sema/expressions/lower_expr.h"
#include "frontend/sema/names/scope.h"

#include <map>
#include <string>
#include <vector>

namespace glider::frontend {

/// Numbers the states of a mission and resolves the types of their parameters, so that cases may
/// name later states.
void declareStates(const ast::File& file, Scope& scope);

/// Lowers one state. The names of states, constants, variables and behaviours must already be in
/// the scope.
class StateLowering {
 public:
  StateLowering(ir::StateId id, Scope& scope)
      : id_(id),
        declaration_(scope.state_declarations[id.index]),
        state_(*declaration_.node),
        scope_(scope) {}
  ir::State run();

 private:
  void visit(const ast::RouteMember& node, const ast::Member& member);
  void visit(const ast::ProfileMember& node, const ast::Member& member);
  void visit(const ast::SensorsMember& node, const ast::Member& member);
  void visit(const ast::SampleMember& node, const ast::Member& member);
  void visit(const ast::Var& node, const ast::Member& member);
  void visit(const ast::EntryMember& node, const ast::Member& member);
  void visit(const ast::EventsMember& node, const ast::Member& member);

  /// Visits the members of one alternative of ast::Member.
  void visitAll(size_t kind);
  /// False, and reported, if the state already has a member of this kind.
  bool first(const ast::Member& member);

  // Behaviours (lower_use.cpp).
  ir::Activity activity(const ast::Use& use, ir::BehaviourKind kind);

  void lowerItem(const ast::SensorItem& item);
  void setPeriod(const ast::Expr& every, size_t from);
  [[nodiscard]] bool isDoubtful(const SensorRead& read, const ast::EventsMember& events) const;
  void warnOfUnlisted(const std::vector<SensorRead>& reads, const ast::EventsMember& node);

  ir::StateId id_;
  StateDeclaration& declaration_;
  const ast::State& state_;
  Scope& scope_;
  ir::State result_;
  std::map<size_t, const ast::Member*> seen_;       ///< by the index of the member's alternative
  std::map<std::string, const ast::Name*> listed_;  ///< by the vehicle's name, or the clock's
  std::map<std::string, bool> warned_;
};

}  // namespace glider::frontend
