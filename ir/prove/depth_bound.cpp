// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/depth_bound.h"

#include <algorithm>
#include <limits>

namespace glider::ir::prove {
namespace {

constexpr double kAnyDepth = std::numeric_limits<double>::infinity();

/// Behaviours in C may order anything.
bool ordersAlone(const Mission& mission) {
  return std::ranges::none_of(mission.states, [&](const State& state) {
    return !mission[state.profile.behaviour].symbol.empty();
  });
}

/// Where no run is deeper, m: under each order the vehicle is within the overshoot of its target,
/// or of where it was when it began to turn.
double greatestDepth(const Ground& ground) {
  const Mission& m = ground.mission;
  if (!ordersAlone(m)) {
    return kAnyDepth;
  }
  double deepest = ground.platform.world.start_depth_m;
  for (const Block& block : m.blocks) {
    for (const Statement& statement : block.statements) {
      const bool down =
          statement.kind == StatementKind::Command &&
          (statement.command == Command::Descend || statement.command == Command::Hover);
      if (down) {
        const Interval& target = ground.intervals[statement.values.at(0).index];
        deepest = std::max(deepest, target.empty ? deepest : target.highest);
      }
    }
  }
  return deepest + ground.platform.envelope.inflection_overshoot_m;
}

class Conditions {
 public:
  explicit Conditions(const Ground& ground)
      : ground_(ground), m_(ground.mission), deepest_(greatestDepth(ground)) {}

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
