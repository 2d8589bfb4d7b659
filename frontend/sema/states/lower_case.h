// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/ast/ast.h"
#include "frontend/sema/expressions/lower_expr.h"
#include "frontend/sema/names/scope.h"

#include <functional>
#include <vector>

namespace glider::frontend {

/// Is told the sensors that each guard reads.
using GuardReads = std::function<void(const std::vector<SensorRead>&)>;

/// Lowers the cases of one list, in the scope's context; what may stand in them depends on the
/// context's list.
class CaseLowering {
 public:
  explicit CaseLowering(Scope& scope) : scope_(scope) {}

  std::vector<ir::Case> lower(const std::vector<ast::Case>& cases, const GuardReads& guard_reads);

 private:
  ir::Case lowerCase(const ast::Case& node, ir::ExprId guard);
  /// False, and reported, if the list has no such transition.
  bool allowed(const ast::Case& node);
  void lowerTarget(const ast::Use& target, ir::Case& lowered);

  Scope& scope_;
};

/// Lowers the mission's `always`, of which there is one at most.
void lowerAlways(const ast::File& file, Scope& scope);

}  // namespace glider::frontend
