// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The expressions of SymbolicState: the value of each operation.

#include "ir/prove/encoding/symbolic_state.h"
#include "support/check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <utility>

namespace glider::ir::prove {
namespace {

/// A sum or product beyond this may overflow, and so be unknown.
constexpr double kNearOverflow = 1e300;

double magnitudeOf(const Interval& interval) {
  return std::max(std::fabs(interval.lowest), std::fabs(interval.highest));
}

/// Whether a result may be unknown although its operands are known; a result without an interval
/// always is.
bool mayOverflow(const Interval& interval) {
  return interval.empty || magnitudeOf(interval) > kNearOverflow;
}

/// The error of one rounding of a result of that size, including what settles to 0.
double roundingOf(const Interval& interval) {
  return std::ldexp(magnitudeOf(interval), -53) + 0x1p-1022;
}

bool isConstant(const Expr& e) {
  return e.op == Op::Constant;
}

bool areExact(const NumberTerm& a, const NumberTerm& b) {
  return a.slack == 0 && b.slack == 0;
}

/// Then so is the least or greatest of them, and one that is chosen: it has the double that the
/// machine gets for it, even where it chooses another one of equal doubles.
bool areMonotone(std::initializer_list<const NumberTerm*> all) {
  return std::ranges::all_of(all, [](const NumberTerm* one) { return one->isMonotone(); });
}

}  // namespace

void SymbolicState::lowerNumber(uint32_t index) {
  const Expr& e = mission_.exprs[index];
  NumberTerm made = arithmetic(e, proof_context_.intervals[index]);
  constexpr double kRoundedUp = 1 + 0x1p-40;  // adding slacks also rounds
  made.slack =
      proof_context_.whole[index] ? 0 : made.slack * kRoundedUp;  // whole: nothing was rounded
  made_.emplace(index, std::move(made));
}

NumberTerm SymbolicState::arithmetic(const Expr& e, const Interval& interval) {
  const z3::expr known = context().bool_val(true);
  switch (groupOf(e.op)) {
    case OpGroup::Constant:
      return {real(e.number), known, 0};
    case OpGroup::Sensor:
      return reading(e.sensor);
    case OpGroup::Clock:
      return {clock(opIn<ClockOp>(e.op)), known, 0};
    case OpGroup::Age:
      return {age(e.sensor), known, 0};
    case OpGroup::Variable:
      return numberOf(e.variable);
    case OpGroup::Temporal:
      return numberOf(e.temporal);
    case OpGroup::Call:
      return numberOf(e.use);
    case OpGroup::Unary:
      return unary(e, interval);
    case OpGroup::Binary:
      return binary(e, interval);
    case OpGroup::Clamp:
      return clamped(e, interval);
    case OpGroup::Select:
      return chosen(e);
    case OpGroup::Function:
      return e.op == Op::Remainder ? remainder(e, interval) : anything(e, interval);
    case OpGroup::Element:
      return anything(e, interval);
    case OpGroup::Truth:
    case OpGroup::Comparison:
    case OpGroup::Known:
    case OpGroup::Logic:
      CHECK(false, "not a number");
  }
  std::unreachable();
}

z3::expr SymbolicState::clock(ClockOp op) {
  switch (op) {
    case ClockOp::MissionTime:
      return missionTime();
    case ClockOp::StateTime:
      return stateTime();
    case ClockOp::ResumeTime:
      return resumeTime();
  }
  CHECK(false, "a clock that the prover does not know");
}

NumberTerm SymbolicState::unary(const Expr& e, const Interval& interval) {
  const NumberTerm& x = operand(e, 0);
  switch (opIn<UnaryOp>(e.op)) {
    case UnaryOp::Negate:
      return {-x.value, x.known, x.slack, x.rounded_once};
    case UnaryOp::Abs:
      return {z3::ite(x.value >= 0, x.value, -x.value), x.known, x.slack, x.rounded_once};
    case UnaryOp::Sqrt:
      break;
  }
  return anything(e, interval);
}

NumberTerm SymbolicState::binary(const Expr& e, const Interval& interval) {
  switch (opIn<BinaryOp>(e.op)) {
    case BinaryOp::Add:
    case BinaryOp::Subtract:
      return sum(e, interval);
    case BinaryOp::Multiply:
      return product(e, interval);
    case BinaryOp::Divide:
      return quotient(e, interval);
    case BinaryOp::Min:
    case BinaryOp::Max:
      return smallerOrLarger(e);
  }
  CHECK(false, "an operation on two numbers that the prover does not know");
}

NumberTerm SymbolicState::sum(const Expr& e, const Interval& interval) {
  const NumberTerm& a = operand(e, 0);
  const NumberTerm& b = operand(e, 1);
  const auto isClock = [&](ExprId id) {
    return groupOf(mission_[id].op) == OpGroup::Clock || proof_context_.mission_times[id.index];
  };
  if (e.op == Op::Subtract && isClock(e.operands[0]) && isClock(e.operands[1])) {
    return {a.value - b.value, a.known && b.known, 0};  // exact: docs/verification.md, Numbers
  }
  if (mayOverflow(interval)) {
    return anything(e, interval);
  }
  return {e.op == Op::Add ? a.value + b.value : a.value - b.value, a.known && b.known,
          a.slack + b.slack + roundingOf(interval), areExact(a, b)};
}

NumberTerm SymbolicState::product(const Expr& e, const Interval& interval) {
  const Expr& left = mission_[e.operands[0]];
  const Expr& right = mission_[e.operands[1]];
  if ((!isConstant(left) && !isConstant(right)) || mayOverflow(interval)) {
    return anything(e, interval);
  }
  const NumberTerm& x = operand(e, isConstant(left) ? 1 : 0);
  const double factor = isConstant(left) ? left.number : right.number;
  return {x.value * real(factor), x.known, x.slack * std::fabs(factor) + roundingOf(interval),
          x.slack == 0};
}

NumberTerm SymbolicState::quotient(const Expr& e, const Interval& interval) {
  const Expr& divisor = mission_[e.operands[1]];
  if (!isConstant(divisor) || divisor.number == 0 || mayOverflow(interval)) {
    NumberTerm result = anything(e, interval);
    const NumberTerm& by = operand(e, 1);
    unknowns_.require(z3::implies(result.known, by.value != 0 || context().bool_val(by.slack > 0)));
    return result;
  }
  const NumberTerm& x = operand(e, 0);
  return {x.value / real(divisor.number), x.known,
          x.slack / std::fabs(divisor.number) + roundingOf(interval), x.slack == 0};
}

NumberTerm SymbolicState::smallerOrLarger(const Expr& e) {
  const NumberTerm& a = operand(e, 0);
  const NumberTerm& b = operand(e, 1);
  const z3::expr first = e.op == Op::Min ? a.value <= b.value : a.value >= b.value;
  return {z3::ite(first, a.value, b.value), a.known && b.known, std::max(a.slack, b.slack),
          areMonotone({&a, &b})};
}

/// If the lowest is above the highest, a clamp jumps from one to the other, so a rounding error
/// does not stay small.
NumberTerm SymbolicState::clamped(const Expr& e, const Interval& interval) {
  const NumberTerm& x = operand(e, 0);
  const NumberTerm& low = operand(e, 1);
  const NumberTerm& high = operand(e, 2);
  const bool rounded = x.slack + low.slack + high.slack > 0;
  const Interval& lowest = proof_context_.intervals[e.operands[1].index];
  const Interval& highest = proof_context_.intervals[e.operands[2].index];
  if (rounded && lowest.highest > highest.lowest) {
    return anything(e, interval);
  }
  return {
      z3::ite(x.value < low.value, low.value, z3::ite(high.value < x.value, high.value, x.value)),
      x.known && low.known && high.known, std::max({x.slack, low.slack, high.slack}),
      areMonotone({&x, &low, &high})};
}

NumberTerm SymbolicState::chosen(const Expr& e) {
  const TruthTerm& condition = truthOperand(e, 0);
  const NumberTerm& yes = operand(e, 1);
  const NumberTerm& no = operand(e, 2);
  return {z3::ite(condition.is_true, yes.value, no.value),
          (condition.is_true && yes.known) || (condition.is_false && no.known),
          std::max(yes.slack, no.slack), areMonotone({&yes, &no})};
}

NumberTerm SymbolicState::remainder(const Expr& e, const Interval& interval) {
  const Expr& period = mission_[e.operands[1]];
  const NumberTerm& x = operand(e, 0);
  if (!relates_remainders_ || !isConstant(period) || !(period.number > 0) || x.slack > 0) {
    return anything(e, interval);
  }
  const z3::expr periods = unknowns_.whole("periods");
  const z3::expr value = x.value - real(period.number) * z3::to_real(periods);
  unknowns_.require(value >= 0 && value < real(period.number));
  return {value, x.known, 0};
}

/// Of the same operands it is the same, also in another condition on this tick: `timeofday`, the
/// distance to a place. An element also depends on the array.
NumberTerm SymbolicState::anything(const Expr& e, const Interval& interval) {
  const auto index = static_cast<uint32_t>(&e - mission_.exprs.data());
  z3::expr known = context().bool_val(true);
  std::vector<z3::expr> terms;
  bool exact = groupOf(e.op) != OpGroup::Element;
  for (const ExprId id : e.operands) {
    if (id.valid()) {
      const NumberTerm& operand = made_.at(id.index);
      known = known && operand.known;
      exact = exact && operand.slack == 0;
      terms.push_back(operand.value);
      terms.push_back(operand.known);
    }
  }
  const std::string key =
      fmt::format("{} {} {}", static_cast<int>(e.op), interval.lowest, interval.highest);
  if (const NumberTerm* made = exact ? unknowns_.resultOf(key, terms) : nullptr) {
    return *made;
  }
  const NumberTerm result{unknowns_.real("value", index), unknowns_.truth("value?", index) && known,
                          0};
  bound(result, interval);
  if (exact) {
    unknowns_.keepResult(key, std::move(terms), result);
  }
  return result;
}

void SymbolicState::lowerTruth(uint32_t index) {
  const Expr& e = mission_.exprs[index];
  auto result = [&]() -> TruthTerm {
    switch (groupOf(e.op)) {
      case OpGroup::Truth:
        return {context().bool_val(e.op == Op::True), context().bool_val(e.op == Op::False)};
      case OpGroup::Variable:
        return truthOf(e.variable);
      case OpGroup::Temporal:
        return truthOf(e.temporal);
      case OpGroup::Call:
        return truthOf(e.use);
      case OpGroup::Known:
        return {operand(e, 0).known, !operand(e, 0).known};
      case OpGroup::Logic:
        return logic(e);
      case OpGroup::Comparison:
        return comparison(e);
      case OpGroup::Constant:
      case OpGroup::Sensor:
      case OpGroup::Clock:
      case OpGroup::Age:
      case OpGroup::Unary:
      case OpGroup::Binary:
      case OpGroup::Function:
      case OpGroup::Clamp:
      case OpGroup::Select:
      case OpGroup::Element:
        break;
    }
    CHECK(false, "not a truth value");
  };
  made_truths_.emplace(index, result());
}

TruthTerm SymbolicState::logic(const Expr& e) {
  const TruthTerm& a = truthOperand(e, 0);
  switch (opIn<LogicOp>(e.op)) {
    case LogicOp::Not:
      return {a.is_false, a.is_true};
    case LogicOp::And: {
      const TruthTerm& b = truthOperand(e, 1);
      return {a.is_true && b.is_true, a.is_false || b.is_false};
    }
    case LogicOp::Or: {
      const TruthTerm& b = truthOperand(e, 1);
      return {a.is_true || b.is_true, a.is_false && b.is_false};
    }
  }
  CHECK(false, "a word of logic that the prover does not know");
}

namespace {

z3::expr compare(Op op, const z3::expr& a, const z3::expr& b) {
  switch (opIn<ComparisonOp>(op)) {
    case ComparisonOp::Less:
      return a < b;
    case ComparisonOp::LessEqual:
      return a <= b;
    case ComparisonOp::Greater:
      return a > b;
    case ComparisonOp::GreaterEqual:
      return a >= b;
    case ComparisonOp::Equal:
      return a == b;
    case ComparisonOp::NotEqual:
      return a != b;
  }
  CHECK(false, "a comparison that the prover does not know");
}

/// Whether a number of this interval may be so small that the machine's result settles to 0.
bool maySettle(const Interval& interval) {
  constexpr double kTiny = 0x1p-1000;
  return interval.empty || (interval.lowest < kTiny && interval.highest > -kTiny);
}

bool holdsOfEqual(Op op) {
  return op == Op::LessEqual || op == Op::GreaterEqual || op == Op::Equal;
}

}  // namespace

/// If the sides differ by less than their rounding errors, the machine may give either answer. Yet
/// for two sides a and b whose doubles never decrease with them (NumberTerm::isMonotone):
///
/// 1. a = b in real numbers gives equal doubles.
/// 2. a < b gives doubles of which the first is less or equal, a > b the opposite. So the machine
///    compares them as the real numbers compare, or as equal ones do.
/// 3. Which of the two is decided by a and b alone, so it is the same for all comparisons of them.
///
/// A depth that the environment keeps to `deepest + 5 m` in real numbers is thus not above the
/// machine's `deepest + 5 m`: the depth is a double, which rounding leaves as it is. Not so near 0,
/// where results settle but a constant or a parameter need not be settled.
TruthTerm SymbolicState::comparison(const Expr& e) {
  const NumberTerm& a = operand(e, 0);
  const NumberTerm& b = operand(e, 1);
  const z3::expr known = a.known && b.known;
  const double slack = a.slack + b.slack;
  z3::expr outcome = compare(e.op, a.value, b.value);
  const auto near0 = [&](size_t i) {
    return maySettle(proof_context_.intervals[e.operands.at(i).index]);
  };
  if (slack > 0) {
    const z3::expr apart = a.value - b.value > real(slack) || b.value - a.value > real(slack);
    const auto index = static_cast<uint32_t>(&e - mission_.exprs.data());
    if (a.isMonotone() && b.isMonotone() && !(near0(0) && near0(1))) {
      const z3::expr as_equal = context().bool_val(holdsOfEqual(e.op));
      outcome = z3::ite(apart || a.value == b.value || differRounded(a.value, b.value, index),
                        outcome, as_equal);
    } else {
      outcome = z3::ite(apart, outcome, unknowns_.truth("rounding", index));
    }
  }
  return {known && outcome, known && !outcome};
}

/// Whether the doubles of two monotone terms, which differ, also differ. `index`: of the expression
/// that asks.
z3::expr SymbolicState::differRounded(const z3::expr& a, const z3::expr& b, uint32_t index) {
  const bool turned = Z3_get_ast_id(context(), b) < Z3_get_ast_id(context(), a);
  const z3::expr& first = turned ? b : a;
  const z3::expr& second = turned ? a : b;
  const auto found = std::ranges::find_if(rounded_pairs_, [&](const RoundedPair& pair) {
    return z3::eq(pair.first, first) && z3::eq(pair.second, second);
  });
  if (found != rounded_pairs_.end()) {
    return found->differ;
  }
  rounded_pairs_.push_back({first, second, unknowns_.truth("rounding", index)});
  return rounded_pairs_.back().differ;
}

}  // namespace glider::ir::prove
