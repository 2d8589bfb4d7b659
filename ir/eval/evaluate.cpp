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

/// Expressions and their values, in the order of their numbers.
class Values {
 public:
  /// All expressions that `id` is made from. Operands have smaller numbers than their users, so all
  /// are found from the greatest number down and can be evaluated from the smallest up.
  Values(const Mission& mission, ExprId id) {
    std::vector<uint32_t> pending{id.index};  // a heap
    while (!pending.empty()) {
      std::ranges::pop_heap(pending);
      const uint32_t number = pending.back();
      pending.pop_back();
      if (!all_.empty() && all_.back().number == number) {
        continue;
      }
      all_.push_back({number, Truth::Unknown});
      const Expr& e = mission.exprs.at(number);
      for (uint32_t k = 0; k < operandCount(e); ++k) {
        pending.push_back(e.operands.at(k).index);
        std::ranges::push_heap(pending);
      }
    }
    std::ranges::reverse(all_);
  }

  struct Known {
    uint32_t number;
    Value value;
  };
  std::vector<Known>& all() { return all_; }
  [[nodiscard]] const Value& at(uint32_t number) const {
    return std::ranges::lower_bound(all_, number, {}, &Known::number)->value;
  }

 private:
  std::vector<Known> all_;
};

/// The values of a call's operands, as numbers; empty for other expressions.
std::vector<double> argumentsOf(const Expr& e, const Values& values) {
  std::vector<double> arguments;
  for (uint32_t i = 0; i < operandCount(e); ++i) {
    arguments.push_back(asNumber(values.at(e.operands.at(i).index)));
  }
  return arguments;
}

Value valueOf(const Mission& mission, const Expr& e, const Values& values, const Leaves& leaves) {
  auto a = [&](size_t i) { return std::get<double>(values.at(e.operands.at(i).index)); };
  auto t = [&](size_t i) { return std::get<Truth>(values.at(e.operands.at(i).index)); };
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
      return leaves(e, argumentsOf(e, values));
    case OpGroup::Unary:
      return unary(e.op, a(0));
    case OpGroup::Binary:
      return binary(e.op, a(0), a(1));
    case OpGroup::Function:
      return function(e.op, argumentsOf(e, values));
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

Value evaluate(const Mission& mission, ExprId id, const Leaves& leaves) {
  Values values(mission, id);
  for (auto& [number, value] : values.all()) {
    value = valueOf(mission, mission.exprs[number], values, leaves);
  }
  return values.at(id.index);
}

}  // namespace glider::ir
