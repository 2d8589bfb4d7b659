// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/llvm/validate/mission_expressions.h"

#include "codegen/llvm/lower/abi_types.h"
#include "support/check.h"

#include <set>

namespace glider::codegen::validate {

using ir::Op;
using ir::OpGroup;

MissionExpressions::Value MissionExpressions::truth(const z3::expr& is_true,
                                                    const z3::expr& is_false) {
  return {numbers().unknown(), is_true.simplify(), is_false.simplify()};
}

MissionExpressions::Value MissionExpressions::ofNumber(const z3::expr& number) {
  return {number, effects_.truth(false), effects_.truth(false)};
}

z3::expr MissionExpressions::asNumber(const Value& value, bool truth) {
  if (!truth) {
    return value.number;
  }
  return z3::ite(value.is_true, numbers().constant(1),
                 z3::ite(value.is_false, numbers().constant(0), numbers().unknown()))
      .simplify();
}

z3::expr MissionExpressions::asNumber(Memory& memory, ir::ExprId id) {
  return asNumber(valueOf(memory, id), mission_[id].type.kind == ir::TypeKind::Bool);
}

/// C4: every part, in the order of the vector.
MissionExpressions::Value MissionExpressions::valueOf(Memory& memory, ir::ExprId id) {
  std::set<uint32_t> parts{id.index};
  for (auto part = parts.rbegin(); part != parts.rend(); ++part) {  // operands have smaller numbers
    const ir::Expr& expr = mission_.exprs.at(*part);
    for (uint32_t i = 0; i < ir::operandCount(expr); ++i) {
      parts.insert(expr.operands.at(i).index);
    }
  }
  Known known;
  for (const uint32_t part : parts) {
    known.emplace(part, evaluate(memory, mission_.exprs[part], known));
  }
  return known.at(id.index);
}

MissionExpressions::Value MissionExpressions::evaluate(Memory& memory, const ir::Expr& expr,
                                                       const Known& operands) {
  const auto number = [&](size_t i) { return operands.at(expr.operands.at(i).index).number; };
  switch (ir::groupOf(expr.op)) {
    case OpGroup::Truth:
      return truth(effects_.truth(expr.op == Op::True), effects_.truth(expr.op == Op::False));
    case OpGroup::Constant:
      return ofNumber(numbers().constant(expr.number));
    case OpGroup::Sensor:
      return ofNumber(
          effects_.load(memory, places().reading(expr.sensor, field::GliderReading::value)));
    case OpGroup::Clock:
      return ofNumber(clock(memory, ir::opIn<ir::ClockOp>(expr.op)));
    case OpGroup::Age:
      return ofNumber(age(memory, expr.sensor));
    case OpGroup::Variable:
      return held(expr, effects_.load(memory, places().variable(expr.variable)));
    case OpGroup::Temporal:
      return held(expr, effects_.load(memory, places().temporal(expr.temporal, 0)));
    case OpGroup::Call:
      return called(memory, expr, operands);
    case OpGroup::Comparison:
      return comparison(expr, number(0), number(1));
    case OpGroup::Known: {  // N10
      const z3::expr known = numbers().isKnown(number(0));
      return truth(known, !known);
    }
    case OpGroup::Logic:
      return logic(expr, operands);
    case OpGroup::Select: {  // N6
      const Value& condition = operands.at(expr.operands[0].index);
      return ofNumber(z3::ite(condition.is_true, number(1),
                              z3::ite(condition.is_false, number(2), numbers().unknown()))
                          .simplify());
    }
    case OpGroup::Element:
      return ofNumber(element(mission_[expr.table], number(0)));
    case OpGroup::Unary:
    case OpGroup::Binary:
    case OpGroup::Function:
    case OpGroup::Clamp:
      return ofNumber(numeric(expr, operands));
  }
  CHECK(false, "an operation without a meaning");
}

z3::expr MissionExpressions::numeric(const ir::Expr& expr, const Known& operands) {
  std::vector<z3::expr> of;
  z3::expr all_known = effects_.truth(true);
  for (uint32_t i = 0; i < ir::operandCount(expr); ++i) {
    of.push_back(operands.at(expr.operands.at(i).index).number);
    all_known = all_known && numbers().isKnown(of.back());
  }
  const OpGroup group = ir::groupOf(expr.op);
  if (group == OpGroup::Unary) {
    return unary(expr, of[0]);
  }
  if (group == OpGroup::Function) {  // N12: they say themselves what an unknown operand gives
    return effects_.pure(std::string(ir::symbolOf(ir::opIn<ir::FunctionOp>(expr.op))), of);
  }
  const z3::expr result =
      group == OpGroup::Clamp ? clamp(of[0], of[1], of[2]) : binary(expr, of[0], of[1]);
  const bool settles = group == OpGroup::Binary && expr.op != Op::Min && expr.op != Op::Max;
  return settles ? result : z3::ite(all_known, result, numbers().unknown()).simplify();
}

/// Unknown stays unknown.
z3::expr MissionExpressions::unary(const ir::Expr& expr, const z3::expr& x) {
  switch (ir::opIn<ir::UnaryOp>(expr.op)) {
    case ir::UnaryOp::Negate:
      return numbers().negate(x);
    case ir::UnaryOp::Abs:
      return numbers().magnitude(x);
    case ir::UnaryOp::Sqrt:
      return numbers().settle(numbers().sqrt(x));
  }
  CHECK(false, "an operation on one number without a meaning");
}

z3::expr MissionExpressions::clamp(const z3::expr& x, const z3::expr& lowest,
                                   const z3::expr& highest) {
  const z3::expr capped = z3::ite(numbers().less(highest, x), highest, x);
  return z3::ite(numbers().less(x, lowest), lowest, capped);
}

/// Sums, products and quotients of unknown operands are NaN, and so unknown.
z3::expr MissionExpressions::binary(const ir::Expr& expr, const z3::expr& a, const z3::expr& b) {
  switch (ir::opIn<ir::BinaryOp>(expr.op)) {
    case ir::BinaryOp::Add:
      return numbers().settle(numbers().add(a, b));
    case ir::BinaryOp::Subtract:
      return numbers().settle(numbers().subtract(a, b));
    case ir::BinaryOp::Multiply:
      return numbers().settle(numbers().multiply(a, b));
    case ir::BinaryOp::Divide:
      return numbers().settle(numbers().divide(a, b));
    case ir::BinaryOp::Min:
      return z3::ite(numbers().less(b, a), b, a);
    case ir::BinaryOp::Max:
      return z3::ite(numbers().less(a, b), b, a);
  }
  CHECK(false, "an operation on two numbers without a meaning");
}

/// N7.
z3::expr MissionExpressions::element(const ir::Table& table, const z3::expr& number) {
  numbers().learnWhole(static_cast<uint32_t>(table.values.size()));
  z3::expr found = numbers().unknown();
  for (size_t i = table.values.size(); i-- > 0;) {
    found = z3::ite(numbers().equal(number, numbers().constant(static_cast<double>(i))),
                    numbers().constant(table.values[i]), found);
  }
  return found.simplify();
}

/// E7.
z3::expr MissionExpressions::clock(const Memory& memory, ir::ClockOp op) {
  namespace context = field::GliderContext;
  const auto read = [&](unsigned field) { return effects_.load(memory, places().context(field)); };
  switch (op) {
    case ir::ClockOp::MissionTime:
      return read(context::mission_time);
    case ir::ClockOp::StateTime:
      return since(memory, read(context::entered));
    case ir::ClockOp::ResumeTime:
      return since(memory, read(context::resumed));
  }
  CHECK(false, "a clock without a meaning");
}

z3::expr MissionExpressions::since(const Memory& memory, const z3::expr& then) {
  const z3::expr now = effects_.load(memory, places().context(field::GliderContext::mission_time));
  return numbers().settle(numbers().subtract(now, then));
}

/// N11.
z3::expr MissionExpressions::age(const Memory& memory, ir::SensorId sensor) {
  return since(memory,
               effects_.load(memory, places().reading(sensor, field::GliderReading::updated)));
}

/// A variable's or a watch's value as it is stored.
MissionExpressions::Value MissionExpressions::held(const ir::Expr& expr, const z3::expr& stored) {
  return expr.type.kind == ir::TypeKind::Bool
             ? truth(numbers().equal(stored, numbers().constant(1)),
                     numbers().equal(stored, numbers().constant(0)))
             : ofNumber(stored);
}

/// C1 to C3, C6: the first evaluation of a use in a tick calls its function.
MissionExpressions::Value MissionExpressions::called(Memory& memory, const ir::Expr& expr,
                                                     const Known& operands) {
  const ir::Function& function = mission_[expr.use];
  const Address made = places().call(expr.use, field::GliderCall::made);
  const Address value = places().call(expr.use, field::GliderCall::value);
  std::vector<z3::expr> arguments;
  for (uint32_t i = 0; i < ir::operandCount(expr); ++i) {
    const ir::ExprId operand = expr.operands.at(i);
    arguments.push_back(
        asNumber(operands.at(operand.index), mission_[operand].type.kind == ir::TypeKind::Bool));
  }
  const z3::expr first = effects_.load(memory, made) == effects_.word(0);
  Memory after = memory;
  const z3::expr settled = numbers().settle(effects_.foreign(after, function.symbol, arguments));
  const z3::expr outside = numbers().less(settled, numbers().constant(function.lowest)) ||
                           numbers().less(numbers().constant(function.highest), settled);
  effects_.store(after, value, z3::ite(outside, numbers().unknown(), settled).simplify());
  effects_.store(after, made, effects_.word(1));
  memory = effects_.either(first.simplify(), after, memory);
  const z3::expr result = effects_.load(memory, value);
  if (expr.type.kind != ir::TypeKind::Bool) {
    return ofNumber(result);
  }
  const z3::expr zero = numbers().equal(result, numbers().constant(0));
  return truth(numbers().isKnown(result) && !zero, zero);
}

/// N10.
MissionExpressions::Value MissionExpressions::comparison(const ir::Expr& expr, const z3::expr& a,
                                                         const z3::expr& b) {
  const z3::expr known = numbers().isKnown(a) && numbers().isKnown(b);
  const auto decided = [&](const z3::expr& holds) {
    return truth(known && holds, known && !holds);
  };
  switch (ir::opIn<ir::ComparisonOp>(expr.op)) {
    case ir::ComparisonOp::Less:
      return decided(numbers().less(a, b));
    case ir::ComparisonOp::LessEqual:
      return decided(!numbers().less(b, a));
    case ir::ComparisonOp::Greater:
      return decided(numbers().less(b, a));
    case ir::ComparisonOp::GreaterEqual:
      return decided(!numbers().less(a, b));
    case ir::ComparisonOp::Equal:
      return decided(numbers().equal(a, b));
    case ir::ComparisonOp::NotEqual:
      return decided(!numbers().equal(a, b));
  }
  CHECK(false, "a comparison without a meaning");
}

/// N10: Kleene's.
MissionExpressions::Value MissionExpressions::logic(const ir::Expr& expr, const Known& operands) {
  const Value& a = operands.at(expr.operands[0].index);
  if (expr.op == Op::Not) {
    return {a.number, a.is_false, a.is_true};
  }
  const Value& b = operands.at(expr.operands[1].index);
  return expr.op == Op::And ? Value{a.number, (a.is_true && b.is_true).simplify(),
                                    (a.is_false || b.is_false).simplify()}
                            : Value{a.number, (a.is_true || b.is_true).simplify(),
                                    (a.is_false && b.is_false).simplify()};
}

}  // namespace glider::codegen::validate
