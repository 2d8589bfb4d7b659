// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/verify/inherited.h"

#include "ir/core/ops.h"

namespace glider::ir {
namespace {

class InheritedAnalysis {
 public:
  InheritedAnalysis(const Mission& mission, const Inheritance& inheritance)
      : m_(mission), inheritance_(inheritance) {
    judged_.variables.assign(m_.variables.size(), true);
  }

  GreatestFixpoint run() {
    for (bool changed = true; changed;) {
      judgeExpressions();
      changed = dropInitials();
      changed = (inheritance_.lost_by_set && dropAssigned()) || changed;
      changed = dropArguments(m_.always) || changed;
      for (const State& state : m_.states) {
        changed = dropArguments(state.cases) || changed;
      }
    }
    return std::move(judged_);
  }

 private:
  void judgeExpressions() {
    judged_.expressions.assign(m_.exprs.size(), false);
    for (size_t i = 0; i < m_.exprs.size(); ++i) {
      judged_.expressions[i] = inheritance_.expression(i, judged_);
    }
  }

  [[nodiscard]] bool has(ExprId id) const { return judged_.expressions[id.index]; }

  /// Removes the property; true if the variable had it.
  bool drop(VariableId id) {
    const bool was = judged_.variables[id.index];
    judged_.variables[id.index] = false;
    return was;
  }

  bool dropInitials() {
    bool changed = false;
    for (uint32_t i = 0; i < m_.variables.size(); ++i) {
      const Variable& variable = m_.variables[i];
      const bool initial = variable.initial.valid() && has(variable.initial);
      changed = (!inheritance_.begins(variable, initial) && drop({i})) || changed;
    }
    return changed;
  }

  bool dropAssigned() {
    bool changed = false;
    for (const Block& block : m_.blocks) {
      for (const Statement& statement : block.statements) {
        const bool taken = statement.kind == StatementKind::Set && !has(statement.value);
        changed = (taken && drop(statement.variable)) || changed;
      }
    }
    return changed;
  }

  bool dropArguments(const std::vector<Case>& cases) {
    bool changed = false;
    for (const Case& c : cases) {
      for (size_t i = 0; i < c.arguments.size(); ++i) {
        changed = (!has(c.arguments[i]) && drop(m_[c.target].parameters[i])) || changed;
      }
    }
    return changed;
  }

  const Mission& m_;
  const Inheritance& inheritance_;
  GreatestFixpoint judged_;
};

}  // namespace

bool GreatestFixpoint::haveOperands(const Expr& e, uint32_t first) const {
  for (uint32_t k = first; k < opInfo(e.op).operands; ++k) {
    if (!expressions[e.operands.at(k).index]) {
      return false;
    }
  }
  return true;
}

GreatestFixpoint greatestFixpoint(const Mission& mission, const Inheritance& inheritance) {
  return InheritedAnalysis(mission, inheritance).run();
}

}  // namespace glider::ir
