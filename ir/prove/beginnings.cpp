// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/core/ops.h"
#include "ir/prove/orders.h"
#include "ir/prove/passes.h"

#include <algorithm>
#include <set>
#include <utility>

namespace glider::ir::prove {
namespace {

/// An order stays in force until the next one, so what every profile and route orders when it
/// begins makes sure that each tick leaves pitch, pump and heading commanded.
class BeginningCheck {
 public:
  explicit BeginningCheck(Proof& proof) : proof_(proof), m_(proof.ground.mission) {}

  void run() {
    for (const State& state : m_.states) {
      check(state.profile, true, "this profile", "neither depth nor pitch");
      check(state.route, false, "this route", "no heading");
    }
  }

 private:
  void check(const Activity& activity, bool vertical, const char* who, const char* what) {
    const bool in_c = !m_[activity.behaviour].symbol.empty();
    if (in_c || orders(activity.entry, vertical)) {
      return;
    }
    if (told_.emplace(activity.range.file, activity.range.begin).second) {
      proof_.diagnostics.report(support::DiagnosticId::nothingOrdered, activity.range, who, what);
    }
  }

  /// Also `known(depth) && depth < bottom`, which is false where the depth is unknown.
  [[nodiscard]] bool isNeverUnknown(ExprId id) const {
    const Expr& e = m_[id];
    if (proof_.ground.known.expressions[id.index] || e.op != Op::And) {
      return proof_.ground.known.expressions[id.index];
    }
    const Expr& asked = m_[e.operands[0]];
    const Expr& then = m_[e.operands[1]];
    const bool guarded =
        asked.op == Op::Known && m_[asked.operands[0]].op == Op::Sensor && isComparison(then.op);
    const auto is_known = [&](ExprId operand) {
      const Expr& x = m_[operand];
      return proof_.ground.known.expressions[operand.index] ||
             (x.op == Op::Sensor && x.sensor == m_[asked.operands[0]].sensor);
    };
    return guarded && is_known(then.operands[0]) && is_known(then.operands[1]);
  }

  /// Whether every way through the block gives an order.
  // NOLINTNEXTLINE(misc-no-recursion): as deep as the mission's text nests
  [[nodiscard]] bool orders(BlockId block, bool vertical) const {
    if (!block.valid()) {
      return false;
    }
    return std::ranges::any_of(m_[block].statements, [&](const Statement& statement) {
      if (statement.kind == StatementKind::Command) {
        return isVertical(statement.command) == vertical;
      }
      // An unknown condition takes neither branch.
      return statement.kind == StatementKind::If && isNeverUnknown(statement.value) &&
             orders(statement.then, vertical) && orders(statement.otherwise, vertical);
    });
  }

  Proof& proof_;
  const Mission& m_;
  std::set<std::pair<uint32_t, uint32_t>> told_;
};

}  // namespace

void passes::beginnings(Proof& proof) {
  BeginningCheck(proof).run();
}

}  // namespace glider::ir::prove
