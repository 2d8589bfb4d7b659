// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/abstract/depth_bound.h"

#include "ir/core/ops.h"

#include <limits>

namespace glider::ir::prove {
namespace {

constexpr double kNoDepthBound = std::numeric_limits<double>::infinity();

class Conditions {
 public:
  Conditions(const ProofContext& proof_context, double deepest)
      : proof_context_(proof_context), m_(proof_context.mission), deepest_(deepest) {}

  [[nodiscard]] bool hold(ExprId id) const {
    const Expr& e = m_[id];
    if (isComparison(e.op)) {
      return compares(e);
    }
    return (e.op == Op::And && hold(e.operands[0]) && hold(e.operands[1])) ||
           (e.op == Op::Or && (hold(e.operands[0]) || hold(e.operands[1])));
  }

 private:
  [[nodiscard]] bool compares(const Expr& e) const {
    switch (opIn<ComparisonOp>(e.op)) {
      case ComparisonOp::LessEqual:
        return isDepth(e.operands[0]) && deepest_ <= lowest(e.operands[1]);
      case ComparisonOp::Less:
        return isDepth(e.operands[0]) && deepest_ < lowest(e.operands[1]);
      case ComparisonOp::GreaterEqual:
        return isDepth(e.operands[1]) && deepest_ <= lowest(e.operands[0]);
      case ComparisonOp::Greater:
        return isDepth(e.operands[1]) && deepest_ < lowest(e.operands[0]);
      case ComparisonOp::Equal:
      case ComparisonOp::NotEqual:
        break;
    }
    return false;
  }

  [[nodiscard]] bool isDepth(ExprId id) const {
    const Expr& e = m_[id];
    return e.op == Op::Sensor && e.sensor == proof_context_.depth;
  }

  [[nodiscard]] double lowest(ExprId id) const {
    const Interval& x = proof_context_.intervals[id.index];
    return x.empty ? -kNoDepthBound : x.lowest;
  }

  const ProofContext& proof_context_;
  const Mission& m_;
  double deepest_;
};

}  // namespace

bool heldByCommands(ExprId condition, const ProofContext& proof_context, double deepest) {
  return Conditions(proof_context, deepest).hold(condition);
}

}  // namespace glider::ir::prove
