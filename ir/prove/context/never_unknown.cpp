// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/context/never_unknown.h"

#include "ir/core/ops.h"
#include "ir/prove/context/same_expression.h"
#include "ir/prove/context/sensors_awaited.h"
#include "ir/verify/inherited.h"
#include "ir/verify/whole_numbers.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace glider::ir::prove {
namespace {

/// A greater result may overflow.
constexpr double kOverflowsFrom = 1e300;

class KnownExpressions {
 public:
  KnownExpressions(const Mission& mission, const std::vector<Interval>& intervals)
      : m_(mission),
        intervals_(intervals),
        whole_(mission.tables.empty() ? std::vector<bool>()
                                      : wholeExpressions(mission, intervals)) {}

  bool isKnown(size_t index, const GreatestFixpoint& judged) const {
    const Expr& e = m_.exprs[index];
    const bool operands = judged.haveOperands(e);
    switch (opInfo(e.op).known) {
      case KnownRule::Always:
        return true;
      case KnownRule::Operands:
        return operands;
      case KnownRule::Bounded:
        return operands && isSmall(index);
      case KnownRule::Quotient:
        return operands && !mayBeZero(e.operands[1]) && isSmall(index);
      case KnownRule::Guarded:
        return operands || isGuarded(e, judged);
      case KnownRule::Choice:
        return operands || isDefaulted(e, judged);
      case KnownRule::Row:
        return operands && isRow(e);
      case KnownRule::Variable:
        return judged.variables[e.variable.index];
      case KnownRule::Maybe:
        break;
    }
    return false;
  }

 private:
  /// Such as `known(depth) && depth < bottom`, which is false where the depth is unknown.
  bool isGuarded(const Expr& both, const GreatestFixpoint& judged) const {
    const Expr& asked = m_[both.operands[0]];
    const Expr& then = m_[both.operands[1]];
    if (asked.op != Op::Known || m_[asked.operands[0]].op != Op::Sensor || !isComparison(then.op)) {
      return false;
    }
    const auto known = [&](ExprId side) {
      const Expr& x = m_[side];
      return judged.expressions[side.index] ||
             (x.op == Op::Sensor && x.sensor == m_[asked.operands[0]].sensor);
    };
    return known(then.operands[0]) && known(then.operands[1]);
  }

  /// Such as `known(x) ? x : 0`.
  bool isDefaulted(const Expr& choice, const GreatestFixpoint& judged) const {
    return isSensorOrElse(m_, choice) && judged.expressions[choice.operands[2].index];
  }

  bool isRow(const Expr& element) const {
    const uint32_t number = element.operands[0].index;
    const auto count = static_cast<double>(m_[element.table].values.size());
    return whole_[number] && intervals_[number].within(0, count - 1);
  }

  bool mayBeZero(ExprId id) const {
    const Interval& x = intervals_[id.index];
    return x.lowest <= 0 && x.highest >= 0;
  }
  bool isSmall(size_t index) const {
    const Interval& x = intervals_[index];
    // An expression that always overflows has no interval.
    return !x.empty && std::max(std::fabs(x.lowest), std::fabs(x.highest)) < kOverflowsFrom;
  }

  const Mission& m_;
  const std::vector<Interval>& intervals_;
  std::vector<bool> whole_;  ///< empty if there is no table
};

bool beginsKnown(const Variable& variable, bool initial) {
  return variable.kind == VariableKind::Parameter || variable.kind == VariableKind::Argument ||
         initial;
}

}  // namespace

GreatestFixpoint neverUnknown(const Mission& mission, const std::vector<Interval>& intervals) {
  const KnownExpressions known(mission, intervals);
  return greatestFixpoint(
      mission,
      {[&](size_t index, const GreatestFixpoint& judged) { return known.isKnown(index, judged); },
       beginsKnown,
       /*lost_by_set=*/false});  // setting a variable to an unknown value has no effect
}

std::vector<bool> knownWhere(const Mission& mission, const std::vector<Interval>& intervals,
                             const GreatestFixpoint& always, const std::vector<ExprId>& shown) {
  const KnownExpressions known(mission, intervals);
  GreatestFixpoint judged{always.variables, {}};
  for (size_t i = 0; i < mission.exprs.size(); ++i) {
    const ExprId id{static_cast<uint32_t>(i)};
    const bool is_shown = std::ranges::any_of(
        shown, [&](ExprId other) { return isSameExpression(mission, id, other); });
    judged.expressions.push_back(is_shown || known.isKnown(i, judged));
  }
  return std::move(judged.expressions);
}

}  // namespace glider::ir::prove
