// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/energy/depth_condition.h"

#include "ir/core/ops.h"
#include "ir/prove/context/same_expression.h"

#include <algorithm>

namespace glider::ir::prove {
namespace {

using Conditions = std::vector<DepthCondition>;

bool isSame(const Mission& mission, const DepthCondition& a, const DepthCondition& b) {
  return a.deeper == b.deeper && isSameExpression(mission, a.limit, b.limit);
}

class Reader {
 public:
  Reader(const Mission& mission, SensorId depth, const std::function<bool(ExprId)>& never)
      : m_(mission), depth_(depth), never_(never) {}

  // NOLINTNEXTLINE(misc-no-recursion): as deep as the mission's text nests
  [[nodiscard]] Conditions of(ExprId id) const {
    const Expr& e = m_[id];
    if (e.op == Op::And) {
      return both(of(e.operands[0]), of(e.operands[1]));
    }
    if (e.op == Op::Or) {
      return either(e.operands[0], e.operands[1]);
    }
    if (e.op == Op::Less || e.op == Op::LessEqual) {
      return compared(e.operands[0], e.operands[1]);
    }
    const bool greater = e.op == Op::Greater || e.op == Op::GreaterEqual;
    return greater ? compared(e.operands[1], e.operands[0]) : Conditions{};
  }

 private:
  static Conditions both(Conditions a, const Conditions& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
  }

  /// What both parts imply, or one if the other is never true.
  // NOLINTNEXTLINE(misc-no-recursion): as deep as the mission's text nests
  [[nodiscard]] Conditions either(ExprId a, ExprId b) const {
    if (never_(a)) {
      return of(b);
    }
    if (never_(b)) {
      return of(a);
    }
    Conditions found = of(a);
    const Conditions others = of(b);
    std::erase_if(found, [&](const DepthCondition& one) {
      return std::ranges::none_of(
          others, [&](const DepthCondition& other) { return isSame(m_, one, other); });
    });
    return found;
  }

  [[nodiscard]] bool isDepth(ExprId id) const {
    return m_[id].op == Op::Sensor && m_[id].sensor == depth_;
  }

  [[nodiscard]] Conditions compared(ExprId less, ExprId more) const {
    if (isDepth(less)) {
      return {{false, more}};
    }
    if (isDepth(more)) {
      return {{true, less}};
    }
    return {};
  }

  const Mission& m_;
  SensorId depth_;
  const std::function<bool(ExprId)>& never_;
};

/// A sum: its constant, and its terms with their signs.
struct Sum {
  double constant = 0;
  std::vector<std::pair<ExprId, int>> terms;
};

// NOLINTNEXTLINE(misc-no-recursion): as deep as the mission's text nests
void add(const Mission& mission, ExprId id, int sign, Sum& sum) {
  const Expr& e = mission[id];
  if (e.op == Op::Constant) {
    sum.constant += sign * e.number;
  } else if (e.op == Op::Add || e.op == Op::Subtract) {
    add(mission, e.operands[0], sign, sum);
    add(mission, e.operands[1], e.op == Op::Add ? sign : -sign, sum);
  } else if (e.op == Op::Negate) {
    add(mission, e.operands[0], -sign, sum);
  } else {
    const auto opposite = std::ranges::find_if(sum.terms, [&](const auto& term) {
      return term.second == -sign && isSameExpression(mission, term.first, id);
    });
    if (opposite != sum.terms.end()) {
      sum.terms.erase(opposite);
    } else {
      sum.terms.emplace_back(id, sign);
    }
  }
}

}  // namespace

std::vector<DepthCondition> depthConditions(const Mission& mission, ExprId guard, SensorId depth,
                                            const std::function<bool(ExprId)>& never) {
  return Reader(mission, depth, never).of(guard);
}

std::optional<double> constantDifference(const Mission& mission, ExprId a, ExprId b) {
  Sum sum;
  add(mission, a, 1, sum);
  add(mission, b, -1, sum);
  return sum.terms.empty() ? std::optional(sum.constant) : std::nullopt;
}

}  // namespace glider::ir::prove
