// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/eval/evaluate.h"

#include "ir/core/ops.h"
#include "ir/eval/arithmetic.h"
#include "support/check.h"

#include <algorithm>
#include <vector>

namespace glider::ir {
namespace {

/// All expressions that `id` is made from, each once, from the smallest number up. Operands have
/// smaller numbers than their users, so they come before these.
std::vector<uint32_t> madeFrom(const Mission& mission, ExprId id) {
  std::vector<uint32_t> found;
  std::vector<uint32_t> pending{id.index};  // a heap
  while (!pending.empty()) {
    std::ranges::pop_heap(pending);
    const uint32_t number = pending.back();
    pending.pop_back();
    if (!found.empty() && found.back() == number) {
      continue;
    }
    found.push_back(number);
    const Expr& e = mission.exprs.at(number);
    for (uint32_t k = 0; k < operandCount(e); ++k) {
      pending.push_back(e.operands.at(k).index);
      std::ranges::push_heap(pending);
    }
  }
  std::ranges::reverse(found);
  return found;
}

/// The values of an expression's operands.
class Operands {
 public:
  /// `places`: of each operand, where its value is in `values`.
  Operands(std::span<const uint32_t> places, const std::vector<Value>& values)
      : places_(places), values_(values) {}
  [[nodiscard]] const Value& at(size_t i) const { return values_.at(places_[i]); }
  [[nodiscard]] std::vector<double> asNumbers() const {
    std::vector<double> numbers;
    for (size_t i = 0; i < places_.size(); ++i) {
      numbers.push_back(asNumber(at(i)));
    }
    return numbers;
  }

 private:
  std::span<const uint32_t> places_;
  const std::vector<Value>& values_;
};

Value valueOf(const Mission& mission, const Expr& e, const Operands& operands,
              const Leaves& leaves) {
  auto a = [&](size_t i) { return std::get<double>(operands.at(i)); };
  auto t = [&](size_t i) { return std::get<Truth>(operands.at(i)); };
  switch (groupOf(e.op)) {
    case OpGroup::Constant:
      return e.number;
    case OpGroup::Truth:
      return truth(e.op == Op::True);
    case OpGroup::Sensor:
    case OpGroup::Age:
    case OpGroup::Clock:
    case OpGroup::Variable:
    case OpGroup::Temporal:
    case OpGroup::Call:
      return leaves(e, operands.asNumbers());
    case OpGroup::Unary:
      return unary(e.op, a(0));
    case OpGroup::Binary:
      return binary(e.op, a(0), a(1));
    case OpGroup::Function:
      return function(e.op, operands.asNumbers());
    case OpGroup::Clamp:
      return clamp(a(0), a(1), a(2));
    case OpGroup::Select:
      return t(0) == Truth::Unknown ? kUnknown : a(t(0) == Truth::True ? 1 : 2);
    case OpGroup::Element:
      return element(mission[e.table], a(0));
    case OpGroup::Comparison:
      return compare(e.op, a(0), a(1));
    case OpGroup::Known:
      return truth(isKnown(a(0)));
    case OpGroup::Logic:
      return logical(opIn<LogicOp>(e.op), t);
  }
  CHECK(false, "an operation without a meaning");
}

}  // namespace

double asNumber(Value value) {
  if (const double* number = std::get_if<double>(&value)) {
    return *number;
  }
  const Truth truth = std::get<Truth>(value);
  return truth == Truth::Unknown ? kUnknown : truth == Truth::True ? 1 : 0;
}

Value asValue(double number, Type type) {
  if (type.kind != TypeKind::Bool) {
    return number;
  }
  return isKnown(number) ? truth(number != 0) : Truth::Unknown;
}

Evaluation::Evaluation(const Mission& mission, ExprId id)
    : mission_(&mission), order_(madeFrom(mission, id)) {
  for (const uint32_t number : order_) {
    const Expr& e = mission.exprs[number];
    for (uint32_t k = 0; k < operandCount(e); ++k) {
      const auto place = std::ranges::lower_bound(order_, e.operands.at(k).index);
      operands_.push_back(static_cast<uint32_t>(place - order_.begin()));
    }
  }
}

Value Evaluation::operator()(const Leaves& leaves) const {
  std::vector<Value> values;
  values.reserve(order_.size());
  size_t first = 0;
  for (const uint32_t number : order_) {
    const Expr& e = mission_->exprs[number];
    const std::span<const uint32_t> places(operands_.data() + first, operandCount(e));
    first += places.size();
    values.push_back(valueOf(*mission_, e, {places, values}, leaves));
  }
  return values.back();
}

const Evaluation& Evaluations::of(ExprId id) {
  const auto found = made_.find(id.index);
  return found != made_.end() ? found->second
                              : made_.try_emplace(id.index, *mission_, id).first->second;
}

Value evaluate(const Mission& mission, ExprId id, const Leaves& leaves) {
  return Evaluation(mission, id)(leaves);
}

}  // namespace glider::ir
