// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/known_variables.h"

#include "ir/core/ops.h"

#include <algorithm>
#include <cmath>

namespace glider::ir::prove {
namespace {

/// Beyond this a result may overflow.
constexpr double kNearOverflow = 1e300;

class Analysis {
 public:
  Analysis(const Mission& mission, const std::vector<Interval>& intervals)
      : m_(mission), intervals_(intervals), known_(mission.variables.size(), true) {}

  /// The greatest set that explains itself: what an unknown value can reach is taken out until
  /// nothing more goes.
  std::vector<bool> run() {
    for (bool changed = true; changed;) {
      workOutExpressions();
      changed = dropInitials();
      changed = dropArguments(m_.always) || changed;
      for (const State& state : m_.states) {
        changed = dropArguments(state.cases) || changed;
      }
    }
    return known_;
  }

 private:
  void workOutExpressions() {
    values_.assign(m_.exprs.size(), false);
    for (size_t i = 0; i < m_.exprs.size(); ++i) {
      values_[i] = isKnown(i);
    }
  }

  bool isKnown(size_t index) const {
    const Expr& e = m_.exprs[index];
    bool operands = true;
    for (uint32_t k = 0; k < opInfo(e.op).operands; ++k) {
      operands = operands && values_[e.operands.at(k).index];
    }
    switch (e.op) {
      case Op::Known:
        return true;
      case Op::Variable:
        return known_[e.variable.index];
      case Op::Divide:
        return operands && !mayBeZero(e.operands[1]) && isSmall(index);
      case Op::Add:
      case Op::Subtract:
      case Op::Multiply:
        return operands && isSmall(index);
      case Op::Constant:
      case Op::True:
      case Op::False:
      case Op::MissionTime:
      case Op::StateTime:
      case Op::ResumeTime:
      case Op::Age:
      case Op::Negate:
      case Op::Abs:
      case Op::Min:
      case Op::Max:
      case Op::Clamp:
      case Op::Select:
      case Op::Less:
      case Op::LessEqual:
      case Op::Greater:
      case Op::GreaterEqual:
      case Op::Equal:
      case Op::NotEqual:
      case Op::Not:
      case Op::And:
      case Op::Or:
        return operands;
      default:
        return false;  // a reading, what is watched, a call, or what has no value everywhere
    }
  }

  bool mayBeZero(ExprId id) const {
    const Interval& x = intervals_[id.index];
    return x.lowest <= 0 && x.highest >= 0;
  }
  bool isSmall(size_t index) const {
    const Interval& x = intervals_[index];
    return std::max(std::fabs(x.lowest), std::fabs(x.highest)) < kNearOverflow;
  }

  bool drop(VariableId id) {
    const bool was = known_[id.index];
    known_[id.index] = false;
    return was;
  }

  bool dropInitials() {
    bool changed = false;
    for (uint32_t i = 0; i < m_.variables.size(); ++i) {
      const Variable& variable = m_.variables[i];
      const bool given = variable.initial.valid() && values_[variable.initial.index];
      const bool settled = variable.kind == VariableKind::Parameter ||
                           variable.kind == VariableKind::Argument || given;
      changed = (!settled && drop({i})) || changed;
    }
    return changed;
  }

  bool dropArguments(const std::vector<Case>& cases) {
    bool changed = false;
    for (const Case& c : cases) {
      for (size_t i = 0; i < c.arguments.size(); ++i) {
        const VariableId parameter = m_[c.target].parameters[i];
        changed = (!values_[c.arguments[i].index] && drop(parameter)) || changed;
      }
    }
    return changed;
  }

  const Mission& m_;
  const std::vector<Interval>& intervals_;
  std::vector<bool> known_;
  std::vector<bool> values_;
};

}  // namespace

std::vector<bool> knownVariables(const Mission& mission, const std::vector<Interval>& intervals) {
  return Analysis(mission, intervals).run();
}

}  // namespace glider::ir::prove
