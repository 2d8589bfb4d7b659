// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/ast/ast.h"
#include "frontend/sema/expressions/lower_expr.h"
#include "frontend/sema/names/scope.h"

#include <functional>
#include <vector>

namespace glider::frontend {

/// Called with the sensors that each guard reads.
using GuardReads = std::function<void(const std::vector<SensorRead>&)>;

/// Lowers the cases of one list, in the scope's context; the context's list determines what they
/// may contain.
class CaseLowering {
 public:
  explicit CaseLowering(Scope& scope) : scope_(scope) {}

  std::vector<ir::Case> lower(const std::vector<ast::Case>& cases, const GuardReads& guard_reads);

 private:
  ir::Case lowerCase(const ast::Case& node, ir::ExprId guard);
  /// False, and reported, if the transition is not allowed in the list.
  bool allowed(const ast::Case& node);
  void lowerTarget(const ast::Use& target, ir::Case& lowered);
  /// What to say about a target that is not a state, nor similar to one.
  [[nodiscard]] std::string insteadOfState(const std::string& name) const;

  Scope& scope_;
};

/// Lowers the mission's `always`, of which there is at most one.
void lowerAlways(const ast::File& file, Scope& scope);

}  // namespace glider::frontend
