// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The operations on numbers: N2 to N7, N12, N13.

#include "ir/certify/expressions.h"
#include "ir/core/ops.h"
#include "support/check.h"

#include <fmt/format.h>

#include <utility>

namespace glider::ir::certify {
namespace {

constexpr double kRounding = 0x1p-53;
constexpr double kWholeEnd = 0x1p53;
constexpr size_t kSmallTable = 64;

/// From half a step above the largest double on, results round to infinity.
Term overflow() {
  return operation("+", {literal(kLargest), literal(0x1p970)});
}

Term absolute(const Term& a) {
  return choice(operation(">=", {a, "0.0"}), a, operation("-", {a}));
}

}  // namespace

/// N2, N3: `result` is a double near `exact`: within half a step of it, and of the same sign.
void Expressions::round(const Term& result, const Term& exact, bool whole) {
  const Term size = out_.real(absolute(exact));
  const Term slack =
      out_.real(operation("+", {operation("*", {literal(kRounding), size}), literal(kTiny)}));
  out_.require(
      operation("<=", {operation("-", {exact, slack}), result, operation("+", {exact, slack})}));
  out_.require(implication(operation(">=", {exact, "0.0"}), operation(">=", {result, "0.0"})));
  out_.require(implication(operation("<=", {exact, "0.0"}), operation("<=", {result, "0.0"})));
  if (whole) {
    out_.require(
        implication(operation("<", {size, literal(kWholeEnd)}), operation("=", {result, exact})));
  }
}

/// The machine's result of expression `id`, whose exact value is `exact`.
Number Expressions::rounded(uint32_t id, const Term& exact, const Term& known) {
  const Range& range = setting_.facts.ranges[id];
  if (range.isOne() && !range.overflows) {
    return {literal(range.lowest), known};
  }
  const Term term = out_.real(exact);
  const bool whole = setting_.facts.whole[id];
  if (whole && !range.overflows && range.magnitude() < kWholeEnd) {
    return {term, known};
  }
  const auto [found, is_new] =
      results_.try_emplace(fmt::format("rounded {} {} {}", term, whole, range.overflows));
  if (is_new) {
    found->second = {out_.fresh("Real"), "true"};
    round(found->second.value, term, whole);
    if (!range.overflows) {
      exact_.emplace(found->second.value, term);
    }
    if (range.overflows) {
      Number& result = found->second;
      result.known = out_.boolean(operation("<", {out_.real(absolute(term)), overflow()}));
      out_.require(implication(
          result.known, operation("<=", {literal(-kLargest), result.value, literal(kLargest)})));
    }
  }
  const Number result{found->second.value, out_.boolean(conjunction({known, found->second.known}))};
  requireRange(result, range);
  return result;
}

/// The number of which `result` is the double: itself if nothing was rounded.
const Term& Expressions::exactOf(const Term& result) const {
  const auto found = exact_.find(result);
  return found == exact_.end() ? result : found->second;
}

/// `result`, which is the double of `exact`.
Term Expressions::roundedFrom(const Term& exact, Term result) {
  if (exact != result) {
    exact_.emplace(result, exact);
  }
  return result;
}

/// Rounding is monotone, and leaves doubles as they are: of two numbers that differ, the doubles
/// are equal or differ alike. Settling (N3) is not of concern where one is far from 0.
void Expressions::keepOrder(const Term& a, const Term& b) {
  const Term& x = exactOf(a);
  const Term& y = exactOf(b);
  if ((x == a && y == b) || !ordered_.emplace(a, b).second) {
    return;
  }
  constexpr double kFar = 0x1p-30;
  const Term far = out_.boolean(disjunction({operation(">=", {absolute(x), literal(kFar)}),
                                             operation(">=", {absolute(y), literal(kFar)})}));
  out_.require(implication(conjunction({far, operation("<=", {x, y})}), operation("<=", {a, b})));
  out_.require(implication(conjunction({far, operation(">=", {x, y})}), operation(">=", {a, b})));
}

/// Rounding is monotone: the range was computed as the machine computes.
void Expressions::requireRange(const Number& number, const Range& range) {
  out_.require(implication(number.known, operation("<=", {literal(range.lowest), number.value,
                                                          literal(range.highest)})));
}

/// A result of which only the interval is known. It is known only if the operands are and `known`
/// is true.
Number Expressions::approximated(uint32_t id, const std::vector<Number>& operands,
                                 const Term& known) {
  const Range& range = setting_.facts.ranges[id];
  std::string key = fmt::format("{}", static_cast<int>(setting_.mission.exprs[id].op));
  std::vector<Term> all{known};
  for (const Number& n : operands) {
    key += " " + n.value;
    all.push_back(n.known);
  }
  const auto [found, is_new] =
      results_.try_emplace(fmt::format("{} {} {}", key, range.lowest, range.highest));
  if (is_new) {
    found->second = anyNumber(range, "true");
  }
  if (range.overflows) {
    all.push_back(found->second.known);
  }
  return {found->second.value, out_.boolean(conjunction(all))};
}

/// N4, and `sqrt`: a negative number has no root.
Number Expressions::unary(uint32_t id, const Number& a) {
  switch (opIn<UnaryOp>(setting_.mission.exprs[id].op)) {
    case UnaryOp::Negate:
      return {roundedFrom(out_.real(operation("-", {exactOf(a.value)})),
                          out_.real(operation("-", {a.value}))),
              a.known};
    case UnaryOp::Abs:
      return {roundedFrom(out_.real(absolute(exactOf(a.value))), out_.real(absolute(a.value))),
              a.known};
    case UnaryOp::Sqrt:
      return approximated(id, {a}, out_.boolean(operation(">=", {a.value, "0.0"})));
  }
  CHECK(false, "an operation on one number without a meaning");
}

/// N5: `b < a ? b : a`.
Term Expressions::smaller(const Term& a, const Term& b) {
  return out_.real(choice(operation("<", {b, a}), b, a));
}

/// N5: `a < b ? b : a`.
Term Expressions::greater(const Term& a, const Term& b) {
  return out_.real(choice(operation("<", {a, b}), b, a));
}

/// N2, N5.
bool Expressions::isOnClockGrid(uint32_t id, size_t operand) const {
  const ExprId of = setting_.mission.exprs[id].operands.at(operand);
  return setting_.facts.on_clock_grid[of.index];
}

Number Expressions::binary(uint32_t id, const Number& a, const Number& b) {
  const Term known = out_.boolean(conjunction({a.known, b.known}));
  switch (opIn<BinaryOp>(setting_.mission.exprs[id].op)) {
    case BinaryOp::Add:
      return rounded(id, operation("+", {a.value, b.value}), known);
    case BinaryOp::Subtract:
      if (isOnClockGrid(id, 0) && isOnClockGrid(id, 1)) {
        return {out_.real(operation("-", {a.value, b.value})), known};
      }
      return rounded(id, operation("-", {a.value, b.value}), known);
    case BinaryOp::Multiply:
      return product(id, a, b);
    case BinaryOp::Divide:
      return quotient(id, a, b);
    case BinaryOp::Min:
      return {roundedFrom(smaller(exactOf(a.value), exactOf(b.value)), smaller(a.value, b.value)),
              known};
    case BinaryOp::Max:
      return {roundedFrom(greater(exactOf(a.value), exactOf(b.value)), greater(a.value, b.value)),
              known};
  }
  CHECK(false, "an operation on two numbers without a meaning");
  std::unreachable();
}

/// Exact, and then rounded, if one side can only have one value: all terms stay linear.
Number Expressions::product(uint32_t id, const Number& a, const Number& b) {
  const Expr& e = setting_.mission.exprs[id];
  const Term known = out_.boolean(conjunction({a.known, b.known}));
  const Range& left = setting_.facts.ranges[e.operands[0].index];
  const Range& right = setting_.facts.ranges[e.operands[1].index];
  if (left.isOne()) {
    return rounded(id, operation("*", {literal(left.lowest), b.value}), known);
  }
  if (right.isOne()) {
    return rounded(id, operation("*", {literal(right.lowest), a.value}), known);
  }
  return approximated(id, {a, b}, "true");
}

/// The same; a quotient by 0 is unknown (N3).
Number Expressions::quotient(uint32_t id, const Number& a, const Number& b) {
  const Expr& e = setting_.mission.exprs[id];
  const Range& divisor = setting_.facts.ranges[e.operands[1].index];
  if (divisor.isOne() && divisor.lowest == 0) {
    return {"0.0", "false"};
  }
  if (divisor.isOne()) {
    return rounded(id, operation("*", {reciprocal(divisor.lowest), a.value}),
                   out_.boolean(conjunction({a.known, b.known})));
  }
  return approximated(id, {a, b}, out_.boolean(negation(operation("=", {b.value, "0.0"}))));
}

/// N5.
Number Expressions::clamp(const Number& x, const Number& l, const Number& h) {
  const Term above = choice(operation("<", {h.value, x.value}), h.value, x.value);
  return {out_.real(choice(operation("<", {x.value, l.value}), l.value, above)),
          out_.boolean(conjunction({x.known, l.known, h.known}))};
}

/// N7.
Number Expressions::element(uint32_t id, const Number& n) {
  const Expr& e = setting_.mission.exprs[id];
  const std::vector<double>& values = setting_.mission[e.table].values;
  if (values.size() > kSmallTable) {
    Number any = approximated(id, {n}, "true");
    any.known = out_.boolean(conjunction({n.known, out_.fresh("Bool")}));
    return any;
  }
  Term value = literal(values.back());
  std::vector<Term> there;
  for (size_t i = values.size(); i-- > 0;) {
    const Term is = out_.boolean(operation("=", {n.value, literal(static_cast<double>(i))}));
    there.push_back(is);
    value = choice(is, literal(values[i]), value);
  }
  return {out_.real(value), out_.boolean(conjunction({n.known, disjunction(there)}))};
}

}  // namespace glider::ir::certify
