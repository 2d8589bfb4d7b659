// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/whole_numbers.h"

#include "ir/core/ops.h"

#include <cmath>

namespace glider::ir::prove {
namespace {

constexpr double kMostWhole = 0x1p53;

class Analysis {
 public:
  Analysis(const Mission& mission, const std::vector<Interval>& intervals)
      : m_(mission), intervals_(intervals), whole_(mission.variables.size(), true) {}

  /// The greatest set that explains itself: a variable that may be given another number is taken
  /// out, until nothing more goes.
  std::vector<bool> run() {
    for (bool changed = true; changed;) {
      workOutExpressions();
      changed = dropInitials();
      changed = dropAssigned() || changed;
      changed = dropArguments(m_.always) || changed;
      for (const State& state : m_.states) {
        changed = dropArguments(state.cases) || changed;
      }
    }
    return values_;
  }

 private:
  void workOutExpressions() {
    values_.assign(m_.exprs.size(), false);
    for (size_t i = 0; i < m_.exprs.size(); ++i) {
      values_[i] = isWhole(i);
    }
  }

  bool isWhole(size_t index) const {
    const Expr& e = m_.exprs[index];
    switch (e.op) {
      case Op::Constant:
        return std::floor(e.number) == e.number && std::fabs(e.number) <= kMostWhole;
      case Op::Variable:
        return whole_[e.variable.index] && isSmall(index);
      case Op::Negate:
      case Op::Abs:
      case Op::Add:
      case Op::Subtract:
      case Op::Multiply:
      case Op::Min:
      case Op::Max:
      case Op::Clamp:
        return operandsFrom(e, 0) && isSmall(index);
      case Op::Select:
        return operandsFrom(e, 1) && isSmall(index);  // the first is the condition
      default:
        return false;
    }
  }

  bool operandsFrom(const Expr& e, uint32_t first) const {
    for (uint32_t k = first; k < opInfo(e.op).operands; ++k) {
      if (!values_[e.operands.at(k).index]) {
        return false;
      }
    }
    return true;
  }

  bool isSmall(size_t index) const {
    return intervals_[index].lowest >= -kMostWhole && intervals_[index].highest <= kMostWhole;
  }

  bool drop(VariableId id) {
    const bool was = whole_[id.index];
    whole_[id.index] = false;
    return was;
  }

  bool dropInitials() {
    bool changed = false;
    for (uint32_t i = 0; i < m_.variables.size(); ++i) {
      const Variable& variable = m_.variables[i];
      const bool given = variable.kind == VariableKind::Argument ||
                         (variable.initial.valid() && values_[variable.initial.index]);
      const bool free = variable.kind == VariableKind::Parameter;  // anything within its range
      changed = ((free || !given) && drop({i})) || changed;
    }
    return changed;
  }

  bool dropAssigned() {
    bool changed = false;
    for (const Block& block : m_.blocks) {
      for (const Statement& statement : block.statements) {
        changed = (statement.kind == StatementKind::Set && !values_[statement.value.index] &&
                   drop(statement.variable)) ||
                  changed;
      }
    }
    return changed;
  }

  bool dropArguments(const std::vector<Case>& cases) {
    bool changed = false;
    for (const Case& c : cases) {
      for (size_t i = 0; i < c.arguments.size(); ++i) {
        changed = (!values_[c.arguments[i].index] && drop(m_[c.target].parameters[i])) || changed;
      }
    }
    return changed;
  }

  const Mission& m_;
  const std::vector<Interval>& intervals_;
  std::vector<bool> whole_;   ///< by variable
  std::vector<bool> values_;  ///< by expression
};

}  // namespace

std::vector<bool> wholeExpressions(const Mission& mission, const std::vector<Interval>& intervals) {
  return Analysis(mission, intervals).run();
}

}  // namespace glider::ir::prove
