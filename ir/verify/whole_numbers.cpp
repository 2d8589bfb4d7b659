// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/verify/whole_numbers.h"

#include "ir/core/ops.h"
#include "ir/verify/inherited.h"

#include <cmath>

namespace glider::ir {
namespace {

/// From here on doubles cannot represent all whole numbers: 2^53 may be 2^53 + 1, rounded.
constexpr double kEndOfWhole = 0x1p53;

class WholeExpressions {
 public:
  WholeExpressions(const Mission& mission, const std::vector<Interval>& intervals)
      : m_(mission), intervals_(intervals) {}

  bool isWhole(size_t index, const GreatestFixpoint& judged) const {
    const Expr& e = m_.exprs[index];
    switch (opInfo(e.op).whole) {
      case WholeRule::Constant:
        return std::floor(e.number) == e.number && std::fabs(e.number) < kEndOfWhole;
      case WholeRule::Variable:
        return judged.variables[e.variable.index] && isSmall(index);
      case WholeRule::Operands:
        return judged.haveOperands(e) && isSmall(index);
      case WholeRule::Choice:
        return judged.haveOperands(e, 1) && isSmall(index);  // the first is the condition
      case WholeRule::Rounds:
        return isSmall(index);
      case WholeRule::Broken:
        break;
    }
    return false;
  }

 private:
  bool isSmall(size_t index) const {
    return intervals_[index].lowest > -kEndOfWhole && intervals_[index].highest < kEndOfWhole;
  }

  const Mission& m_;
  const std::vector<Interval>& intervals_;
};

/// A parameter may be anything within its range.
bool beginsWhole(const Variable& variable, bool initial) {
  return variable.kind != VariableKind::Parameter &&
         (variable.kind == VariableKind::Argument || initial);
}

}  // namespace

std::vector<bool> wholeExpressions(const Mission& mission, const std::vector<Interval>& intervals) {
  const WholeExpressions whole(mission, intervals);
  return greatestFixpoint(mission, {[&](size_t index, const GreatestFixpoint& judged) {
                                      return whole.isWhole(index, judged);
                                    },
                                    beginsWhole, /*lost_by_set=*/true})
      .expressions;
}

}  // namespace glider::ir
