// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What every constant of a script is required to satisfy can be satisfied for any values of the
// terms: some of them stand for paths that the tick does not take.

#include "ir/certify/expressions.h"

#include "ir/core/ops.h"
#include "support/check.h"

#include <set>

namespace glider::ir::certify {
namespace {

Number constant(double value) {
  return {literal(value), "true"};
}

std::set<uint32_t> partsOf(const Mission& mission, ExprId root) {
  std::set<uint32_t> parts;
  std::set<uint32_t> open{root.index};
  while (!open.empty()) {
    const uint32_t id =
        open.extract(std::prev(open.end())).value();  // operands have smaller numbers
    parts.insert(id);
    const Expr& e = mission.exprs.at(id);
    for (uint32_t k = 0; k < operandCount(e); ++k) {
      open.insert(e.operands.at(k).index);
    }
  }
  return parts;
}

}  // namespace

Value Expressions::evaluate(ExprId id, const Store& store) {
  Values values;
  for (const uint32_t part : partsOf(setting_.mission, id)) {
    values[part] = valueOf(part, values, store);
  }
  return values.at(id.index);
}

Number Expressions::number(ExprId id, const Store& store) {
  return std::get<Number>(evaluate(id, store));
}

Truths Expressions::truth(ExprId id, const Store& store) {
  return std::get<Truths>(evaluate(id, store));
}

Truths Expressions::promise(ExprId id, const Store& store) {
  true_depth_ = true;
  const Truths result = truth(id, store);
  true_depth_ = false;
  return result;
}

Value Expressions::valueOf(uint32_t id, const Values& values, const Store& store) {
  const Expr& e = setting_.mission.exprs[id];
  const auto n = [&](size_t i) { return std::get<Number>(values.at(e.operands.at(i).index)); };
  const auto t = [&](size_t i) { return std::get<Truths>(values.at(e.operands.at(i).index)); };
  switch (groupOf(e.op)) {
    case OpGroup::Constant:
      return constant(e.number);
    case OpGroup::Truth:
      return e.op == Op::True ? Truths{"true", "false"} : Truths{"false", "true"};
    case OpGroup::Sensor:
    case OpGroup::Age:
    case OpGroup::Clock:
    case OpGroup::Variable:
    case OpGroup::Temporal:
    case OpGroup::Call:
      return leaf(e, store);
    case OpGroup::Unary:
      return unary(id, n(0));
    case OpGroup::Binary:
      return binary(id, n(0), n(1));
    case OpGroup::Function: {
      std::vector<Number> operands;
      for (uint32_t k = 0; k < operandCount(e); ++k) {
        operands.push_back(n(k));
      }
      return approximated(id, operands, "true");
    }
    case OpGroup::Clamp:
      return clamp(n(0), n(1), n(2));
    case OpGroup::Select:
      return select(t(0), n(1), n(2));
    case OpGroup::Element:
      return element(id, n(0));
    case OpGroup::Comparison:
      return comparison(opIn<ComparisonOp>(e.op), n(0), n(1));
    case OpGroup::Known:
      return Truths{n(0).known, out_.boolean(negation(n(0).known))};
    case OpGroup::Logic:
      return logic(opIn<LogicOp>(e.op), t(0), e.op == Op::Not ? Truths{} : t(1));
  }
  CHECK(false, "an operation without a meaning");
}

Value Expressions::leaf(const Expr& e, const Store& store) {
  switch (groupOf(e.op)) {
    case OpGroup::Sensor:
      return true_depth_ && isDepth(e.sensor) ? Number{depth_, "true"} : readingOf(e.sensor).value;
    case OpGroup::Age:
      return Number{readingOf(e.sensor).age, "true"};
    case OpGroup::Clock:
      return clock(opIn<ClockOp>(e.op), store);
    case OpGroup::Variable:
      return store.variables.at(e.variable.index);
    case OpGroup::Temporal:
      return store.temporals.at(e.temporal.index);
    case OpGroup::Call:
    case OpGroup::Constant:
    case OpGroup::Truth:
    case OpGroup::Unary:
    case OpGroup::Binary:
    case OpGroup::Function:
    case OpGroup::Clamp:
    case OpGroup::Select:
    case OpGroup::Element:
    case OpGroup::Comparison:
    case OpGroup::Known:
    case OpGroup::Logic:
      break;
  }
  return call(e);
}

/// E7. Differences of clocks are exact (docs/verification.md, Numbers).
Number Expressions::clock(ClockOp op, const Store& store) {
  switch (op) {
    case ClockOp::MissionTime:
      return {time_, "true"};
    case ClockOp::StateTime:
      return {out_.real(operation("-", {time_, store.entered.back()})), "true"};
    case ClockOp::ResumeTime:
      return {out_.real(operation("-", {time_, store.resumed})), "true"};
  }
  CHECK(false, "a clock without a meaning");
}

bool Expressions::isDepth(SensorId id) const {
  const Sensor& s = setting_.mission[id];
  const platforms::PlatformSensor* depth = setting_.platform.find("depth");
  return depth != nullptr && s.symbol.empty() && s.id == depth->id;
}

/// Step 2 and N11: a reading is in the sensor's range and no older than stale_after, or unknown.
/// V7: that of the depth is near the vehicle's.
const Reading& Expressions::readingOf(SensorId id) {
  const auto [found, is_new] = readings_.try_emplace(id.index);
  if (!is_new) {
    return found->second;
  }
  const Sensor& s = setting_.mission[id];
  Reading& r = found->second;
  r.value = anyNumber(rangeOfReadings(s), "true");
  r.age = out_.fresh("Real");
  out_.require(operation("<=", {"0.0", r.age, time_}));
  out_.require(implication(r.value.known, operation("<=", {r.age, literal(s.stale_after_s)})));
  if (isDepth(id)) {
    const Term error = literal(setting_.platform.world.depth_error_m);
    out_.require(
        implication(r.value.known, operation("<=", {operation("-", {depth_, error}), r.value.value,
                                                    operation("+", {depth_, error})})));
  }
  return r;
}

/// C3, C6.
Value Expressions::call(const Expr& e) {
  const auto [found, is_new] = calls_.try_emplace(e.use.index);
  if (is_new && e.type.kind == TypeKind::Bool) {
    const Truths any{out_.fresh("Bool"), out_.fresh("Bool")};
    out_.require(negation(conjunction({any.is_true, any.is_false})));
    found->second = any;
  } else if (is_new) {
    const Function& f = setting_.mission[e.use];
    found->second =
        anyNumber(Range{std::max(f.lowest, -kLargest), std::min(f.highest, kLargest)}, "true");
  }
  return found->second;
}

Number Expressions::anyNumber(const Range& range, const Term& known) {
  const Number any{out_.fresh("Real"), out_.fresh("Bool")};
  out_.require(operation("<=", {literal(range.lowest), any.value, literal(range.highest)}));
  out_.require(implication(any.known, known));
  return any;
}

/// N6.
Number Expressions::select(const Truths& c, const Number& a, const Number& b) {
  return {roundedFrom(out_.real(choice(c.is_true, exactOf(a.value), exactOf(b.value))),
                      out_.real(choice(c.is_true, a.value, b.value))),
          out_.boolean(disjunction(
              {conjunction({c.is_true, a.known}), conjunction({c.is_false, b.known})}))};
}

/// N10.
Truths Expressions::comparison(ComparisonOp op, const Number& a, const Number& b) {
  const auto relation = [&]() -> Term {
    switch (op) {
      case ComparisonOp::Less:
        return operation("<", {a.value, b.value});
      case ComparisonOp::LessEqual:
        return operation("<=", {a.value, b.value});
      case ComparisonOp::Greater:
        return operation(">", {a.value, b.value});
      case ComparisonOp::GreaterEqual:
        return operation(">=", {a.value, b.value});
      case ComparisonOp::Equal:
        return operation("=", {a.value, b.value});
      case ComparisonOp::NotEqual:
        return negation(operation("=", {a.value, b.value}));
    }
    CHECK(false, "a comparison without a meaning");
  };
  keepOrder(a.value, b.value);
  const Term holds = out_.boolean(relation());
  return {out_.boolean(conjunction({a.known, b.known, holds})),
          out_.boolean(conjunction({a.known, b.known, negation(holds)}))};
}

/// N10: Kleene's.
Truths Expressions::logic(LogicOp op, const Truths& a, const Truths& b) {
  switch (op) {
    case LogicOp::Not:
      return {a.is_false, a.is_true};
    case LogicOp::And:
      return {out_.boolean(conjunction({a.is_true, b.is_true})),
              out_.boolean(disjunction({a.is_false, b.is_false}))};
    case LogicOp::Or:
      return {out_.boolean(disjunction({a.is_true, b.is_true})),
              out_.boolean(conjunction({a.is_false, b.is_false}))};
  }
  CHECK(false, "a word of logic without a meaning");
}

}  // namespace glider::ir::certify
