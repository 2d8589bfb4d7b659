// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/opt/passes.h"
#include "ir/opt/replace.h"

#include <bit>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

namespace glider::ir::opt {
namespace {

/// Everything that makes two expressions the same; numbers by their bits.
auto keyOf(const Expr& e) {
  return std::tuple(e.op, e.type.kind, e.type.dimension.exponents, e.operands,
                    std::bit_cast<uint64_t>(e.number), e.sensor, e.variable, e.temporal, e.table);
}

/// Everything that makes two temporals the same.
auto keyOf(const Temporal& t) {
  return std::tuple(t.kind, t.list, t.state, t.operand, t.duration,
                    std::bit_cast<uint64_t>(t.length), t.along, t.leg,
                    std::bit_cast<uint64_t>(t.dive), std::bit_cast<uint64_t>(t.climb));
}

/// Goes through the expressions in the order of the vector, so that operands are shared before
/// their users.
class Sharing {
 public:
  explicit Sharing(Mission& mission) : m_(mission), by_(mission.exprs.size()) {}

  void run() {
    for (uint32_t i = 0; i < by_.size(); ++i) {
      Expr& expr = m_.exprs[i];
      for (ExprId& operand : expr.operands) {
        shared(operand);
      }
      if (expr.temporal.valid()) {
        expr.temporal = firstLike(expr.temporal);
      }
      // Calls are not shared: functions are called in the order of the expressions.
      by_[i] =
          expr.op == Op::Call ? ExprId{i} : exprs_.emplace(keyOf(expr), ExprId{i}).first->second;
    }
    for (uint32_t i = 0; i < m_.temporals.size(); ++i) {
      firstLike({i});  // those that no expression reads
    }
    replace(m_, by_);
  }

 private:
  void shared(ExprId& id) const { id = id.valid() ? by_[id.index] : id; }

  /// What a temporal watches precedes every expression that uses it, and so has already been
  /// shared.
  TemporalId firstLike(TemporalId id) {
    Temporal& temporal = m_.temporals[id.index];
    shared(temporal.operand);
    shared(temporal.duration);
    shared(temporal.along);
    const TemporalId first = temporals_.emplace(keyOf(temporal), id).first->second;
    if (first != id) {
      temporal.list = ListKind::State;  // of no state: it is removed
      temporal.state = {};
    }
    return first;
  }

  Mission& m_;
  std::vector<ExprId> by_;
  std::map<decltype(keyOf(std::declval<Expr>())), ExprId> exprs_;
  std::map<decltype(keyOf(std::declval<Temporal>())), TemporalId> temporals_;
};

}  // namespace

/// An expression has the value of the moment at which it is evaluated, so one node may serve any
/// number of places. Two temporals of one list that watch the same start and advance together.
void shareExpressions(Mission& mission) {
  Sharing(mission).run();
}

}  // namespace glider::ir::opt
