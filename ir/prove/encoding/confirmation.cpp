// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/encoding/confirmation.h"

#include "ir/core/ops.h"
#include "ir/core/walk.h"
#include "ir/eval/arithmetic.h"
#include "ir/eval/evaluate.h"
#include "support/check.h"

#include <algorithm>
#include <cmath>

namespace glider::ir::prove {
namespace {

/// Results that differ by less, in relation to their size, are the same.
constexpr double kSame = 1e-6;

/// The values of a model of a moment, as the expressions of the mission see them.
class ModelValues {
 public:
  ModelValues(const z3::model& model, SymbolicState& moment) : model_(model), moment_(moment) {}

  // NOLINTNEXTLINE(misc-no-recursion): as deep as `held` is written in `held`
  Value valueOf(ExprId id) {
    return evaluate(moment_.mission(), id,
                    [this](const Expr& e, std::span<const double>) { return leaf(e); });
  }

 private:
  // NOLINTNEXTLINE(misc-no-recursion): see valueOf
  Value leaf(const Expr& e) {
    const bool truth = e.type.kind == TypeKind::Bool;
    const OpGroup group = groupOf(e.op);
    if (group == OpGroup::Sensor) {
      return number(moment_.reading(e.sensor));
    }
    if (group == OpGroup::Age) {
      return doubleOf(model_, moment_.age(e.sensor));
    }
    if (group == OpGroup::Clock) {
      return doubleOf(model_, clock(e.op));
    }
    if (group == OpGroup::Variable) {
      return truth ? this->truth(moment_.truthOf(e.variable))
                   : number(moment_.numberOf(e.variable));
    }
    if (group == OpGroup::Temporal) {
      return truth ? watched(e.temporal) : number(moment_.numberOf(e.temporal));
    }
    CHECK(group == OpGroup::Call, "not a leaf");
    return truth ? this->truth(moment_.truthOf(e.use)) : number(moment_.numberOf(e.use));
  }

  const z3::expr& clock(Op op) {
    return op == Op::MissionTime ? moment_.missionTime()
           : op == Op::StateTime ? moment_.stateTime()
                                 : moment_.resumeTime();
  }

  Value number(const NumberTerm& term) const {
    return holds(model_, term.known) ? Value(doubleOf(model_, term.value)) : Value(kUnknown);
  }
  Value truth(const TruthTerm& term) const {
    return holds(model_, term.is_true)    ? Truth::True
           : holds(model_, term.is_false) ? Truth::False
                                          : Truth::Unknown;
  }

  /// True only while what it watches is; of that nothing is known if it reads what a list has set
  /// since.
  // NOLINTNEXTLINE(misc-no-recursion): see valueOf
  Value watched(TemporalId id) {
    const Value seen = truth(moment_.truthOf(id));
    const bool can_be = std::get<Truth>(seen) != Truth::True ||
                        !moment_.proof_context().set_since[id.index].empty() ||
                        std::get<Truth>(valueOf(moment_.mission()[id].operand)) == Truth::True;
    return can_be ? seen : Value(Truth::Unknown);
  }

  const z3::model& model_;
  SymbolicState& moment_;
};

/// Whether it is computed from readings and constants alone.
bool readsOnly(const Mission& m, ExprId id) {
  return !anyIn(m, id, [](const Expr& e) {
    const OpGroup group = groupOf(e.op);
    return group == OpGroup::Age || group == OpGroup::Clock || group == OpGroup::Variable ||
           group == OpGroup::Temporal || group == OpGroup::Call;
  });
}

bool isSame(double a, double b) {
  return std::fabs(a - b) <= kSame * std::max({1.0, std::fabs(a), std::fabs(b)});
}

}  // namespace

bool isConfirmed(const z3::model& model, SymbolicState& moment, ExprId guard) {
  return std::get<Truth>(ModelValues(model, moment).valueOf(guard)) == Truth::True;
}

bool fitReadings(const z3::model& model, const Unknowns& unknowns,
                 std::span<SymbolicState* const> moments) {
  for (size_t i = 0; i < unknowns.made().size(); ++i) {
    const z3::expr& made = unknowns.made()[i];
    const auto of = unknowns.standFor()[i];
    const bool result_of = of && made.decl().name().str().contains("value!");
    const bool free = !model.eval(made).is_numeral();  // the question does not depend on it
    if (!result_of || !made.is_real() || free || !readsOnly(moments.front()->mission(), {*of})) {
      continue;
    }
    const double result = doubleOf(model, made);
    const bool fits = std::ranges::any_of(moments, [&](SymbolicState* moment) {
      const double value = std::get<double>(ModelValues(model, *moment).valueOf({*of}));
      return isSame(value, result);
    });
    if (!fits) {
      return false;
    }
  }
  return true;
}

}  // namespace glider::ir::prove
