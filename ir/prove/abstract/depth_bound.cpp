// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/abstract/depth_bound.h"

#include "ir/prove/abstract/state_depths.h"

#include <algorithm>
#include <limits>

namespace glider::ir::prove {
namespace {

constexpr double kAnyDepth = std::numeric_limits<double>::infinity();

class Conditions {
 public:
  explicit Conditions(const Ground& ground)
      : ground_(ground), m_(ground.mission), deepest_(std::ranges::max(deepestByState(ground))) {}

  [[nodiscard]] bool hold(ExprId id) const {
    const Expr& e = m_[id];
    switch (e.op) {
      case Op::And:
        return hold(e.operands[0]) && hold(e.operands[1]);
      case Op::Or:
        return hold(e.operands[0]) || hold(e.operands[1]);
      case Op::LessEqual:
        return isDepth(e.operands[0]) && deepest_ <= lowest(e.operands[1]);
      case Op::Less:
        return isDepth(e.operands[0]) && deepest_ < lowest(e.operands[1]);
      case Op::GreaterEqual:
        return isDepth(e.operands[1]) && deepest_ <= lowest(e.operands[0]);
      case Op::Greater:
        return isDepth(e.operands[1]) && deepest_ < lowest(e.operands[0]);
      default:
        return false;
    }
  }

 private:
  [[nodiscard]] bool isDepth(ExprId id) const {
    const Expr& e = m_[id];
    return e.op == Op::Sensor && e.sensor == ground_.depth;
  }

  [[nodiscard]] double lowest(ExprId id) const {
    const Interval& x = ground_.intervals[id.index];
    return x.empty ? -kAnyDepth : x.lowest;
  }

  const Ground& ground_;
  const Mission& m_;
  double deepest_;
};

}  // namespace

bool heldByOrders(ExprId condition, const Ground& ground) {
  return Conditions(ground).hold(condition);
}

}  // namespace glider::ir::prove
