// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/core/ops.h"

#include <algorithm>
#include <array>
#include <span>

namespace glider::ir {
namespace {

constexpr Type kBool{TypeKind::Bool, {}};
constexpr Type kNumber{TypeKind::Quantity, support::dimension::number};
constexpr Type kTime{TypeKind::Quantity, support::dimension::time};
constexpr Type kLength{TypeKind::Quantity, support::dimension::length};
constexpr Type kAngle{TypeKind::Quantity, support::dimension::angle};
constexpr Type kLatitude{TypeKind::Latitude, {}};
constexpr Type kLongitude{TypeKind::Longitude, {}};

std::optional<Type> quantity(std::optional<support::Dimension> dimension) {
  return dimension ? std::optional(Type{TypeKind::Quantity, *dimension}) : std::nullopt;
}

std::optional<Type> when(bool fits, Type type) {
  return fits ? std::optional(type) : std::nullopt;
}

/// Of a C function.
std::optional<Type> called(const Mission& mission, const Expr& expr) {
  const Function& function = mission[expr.use];
  if (operandCount(expr) != function.parameters.size()) {
    return std::nullopt;
  }
  for (size_t i = 0; i < function.parameters.size(); ++i) {
    if (mission[expr.operands.at(i)].type != function.parameters[i].type) {
      return std::nullopt;
    }
  }
  return function.result;
}

bool haveOneType(std::span<const Type> types) {
  return std::ranges::all_of(types, [&](Type type) { return type == types.front(); });
}

bool arePlaces(std::span<const Type> types) {
  return types[0] == kLatitude && types[1] == kLongitude && types[2] == kLatitude &&
         types[3] == kLongitude;
}

/// Of a truth value that is watched, or a window.
std::optional<Type> watched(const Mission& mission, const Temporal& t) {
  if (!isWindow(t.kind)) {
    return kBool;
  }
  const Type value = mission[t.operand].type;
  if (value.kind == TypeKind::Bool) {
    return std::nullopt;
  }
  const Type along = t.along.valid() ? mission[t.along].type : kTime;
  if (t.kind == TemporalKind::Slope) {
    const bool quantities = value.kind == TypeKind::Quantity && along.kind == TypeKind::Quantity;
    return quantities ? quantity(support::quotient(value.dimension, along.dimension))
                      : std::nullopt;
  }
  return value;
}

}  // namespace

bool isOrdering(Op op) {
  return op == Op::Less || op == Op::LessEqual || op == Op::Greater || op == Op::GreaterEqual;
}

Op negated(Op comparison) {
  switch (opIn<ComparisonOp>(comparison)) {
    case ComparisonOp::Less:
      return Op::GreaterEqual;
    case ComparisonOp::LessEqual:
      return Op::Greater;
    case ComparisonOp::Greater:
      return Op::LessEqual;
    case ComparisonOp::GreaterEqual:
      return Op::Less;
    case ComparisonOp::Equal:
      return Op::NotEqual;
    case ComparisonOp::NotEqual:
      return Op::Equal;
  }
  CHECK(false, "a comparison without an opposite");
}

Op mirrored(Op comparison) {
  switch (opIn<ComparisonOp>(comparison)) {
    case ComparisonOp::Less:
      return Op::Greater;
    case ComparisonOp::LessEqual:
      return Op::GreaterEqual;
    case ComparisonOp::Greater:
      return Op::Less;
    case ComparisonOp::GreaterEqual:
      return Op::LessEqual;
    case ComparisonOp::Equal:
    case ComparisonOp::NotEqual:
      return comparison;
  }
  CHECK(false, "a comparison without a mirror image");
}

bool isWindow(TemporalKind kind) {
  return kind != TemporalKind::Became && kind != TemporalKind::Held;
}

const OpInfo* findOp(std::string_view text) {
  auto found = std::ranges::find(kOps, text, &OpInfo::text);
  return found == kOps.end() ? nullptr : &*found;
}

uint32_t operandCount(const Expr& expr) {
  if (expr.op != Op::Call) {
    return opInfo(expr.op).operands;
  }
  const auto end = std::ranges::find_if(expr.operands, [](ExprId id) { return !id.valid(); });
  return static_cast<uint32_t>(end - expr.operands.begin());
}

const std::vector<CommandInfo>& commands() {
  constexpr Type length = kLength, angle = kAngle, latitude = kLatitude, longitude = kLongitude;
  static const std::vector<CommandInfo> kCommands = {
#define PARAMETER(name, type) Parameter{#name, type},
#define COMMAND(name, text, symbol, ...) {Command::name, text, symbol, {__VA_ARGS__}},
#include "ir/core/commands.def"
#undef COMMAND
#undef PARAMETER
  };
  return kCommands;
}

std::optional<Type> resultType(const Mission& mission, const Expr& expr) {
  const OpInfo& op = opInfo(expr.op);
  std::array<Type, kMostOperands> all;
  for (uint32_t i = 0; i < op.operands; ++i) {
    all.at(i) = mission[expr.operands.at(i)].type;
  }
  const auto of = std::span<const Type>(all).first(std::max(op.operands, 1U));
  const Type a = of.front();
  const Type b = of.back();
  const bool quantities = a.kind == TypeKind::Quantity && b.kind == TypeKind::Quantity;
  const bool numbers = a.kind != TypeKind::Bool && b.kind != TypeKind::Bool;
  switch (op.type) {
    case TypeRule::Own:
      return when(expr.type.kind != TypeKind::Bool, expr.type);
    case TypeRule::Truth:
      return kBool;
    case TypeRule::Time:
      return kTime;
    case TypeRule::Sensor:
      return mission[expr.sensor].type;
    case TypeRule::Variable:
      return mission[expr.variable].type;
    case TypeRule::Temporal:
      return watched(mission, mission[expr.temporal]);
    case TypeRule::Element:
      return when(a == kNumber, mission[expr.table].type);
    case TypeRule::Call:
      return called(mission, expr);
    case TypeRule::Same:
      return when(numbers && haveOneType(of), a);
    case TypeRule::Root:
      return quantities ? quantity(support::squareRoot(a.dimension)) : std::nullopt;
    case TypeRule::Product:
      return quantities ? quantity(support::product(a.dimension, b.dimension)) : std::nullopt;
    case TypeRule::Quotient:
      return quantities ? quantity(support::quotient(a.dimension, b.dimension))
                        : when(numbers && a == b, kNumber);
    case TypeRule::OfAngle:
      return when(a == kAngle, kNumber);
    case TypeRule::ToAngle:
      return when(quantities && a == b, kAngle);
    case TypeRule::Length:
      return when(arePlaces(of), kLength);
    case TypeRule::Course:
      return when(arePlaces(of), kAngle);
    case TypeRule::Choice:
      return when(a == kBool && of[1] == b && b.kind != TypeKind::Bool, b);
    case TypeRule::Comparison:
      return when(numbers && a == b, kBool);
    case TypeRule::Known:
      return when(numbers, kBool);
    case TypeRule::Logic:
      return when(a == kBool && b == kBool, kBool);
  }
  CHECK(false, "a type without a rule");
}

}  // namespace glider::ir
