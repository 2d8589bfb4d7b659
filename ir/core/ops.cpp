// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/core/ops.h"

#include <algorithm>
#include <array>

namespace glider::ir {
namespace {

constexpr auto kOps = std::to_array<OpInfo>({
#define OP(name, text, operands, result) {Op::name, text, operands},
#include "ir/core/ops.def"
#undef OP
});

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

/// Of operations that compute: `a` and `b` are the first two operands' types (`b` is `a` for one
/// operand).
std::optional<Type> arithmetic(Op op, Type a, Type b) {
  const bool quantities = a.kind == TypeKind::Quantity && b.kind == TypeKind::Quantity;
  switch (op) {
    case Op::Sqrt:
      return quantities ? quantity(support::squareRoot(a.dimension)) : std::nullopt;
    case Op::Multiply:
      return quantities ? quantity(support::product(a.dimension, b.dimension)) : std::nullopt;
    case Op::Divide:
      if (!quantities) {
        return a == b ? std::optional(kNumber) : std::nullopt;
      }
      return quantity(support::quotient(a.dimension, b.dimension));
    default:  // Negate, Abs, Add, Subtract, Min, Max, Clamp
      return a == b ? std::optional(a) : std::nullopt;
  }
}

/// Of what runtime/numbers computes.
std::optional<Type> geometry(const Mission& mission, const Expr& expr) {
  auto operand = [&](uint32_t i) { return mission[expr.operands.at(i)].type; };
  auto from = [](bool fits, Type type) { return fits ? std::optional(type) : std::nullopt; };
  switch (expr.op) {
    case Op::Sin:
    case Op::Cos:
    case Op::Tan:
      return from(operand(0) == kAngle, kNumber);
    case Op::Atan2:
      return from(operand(0) == operand(1) && operand(0).kind == TypeKind::Quantity, kAngle);
    default: {  // Distance, Bearing
      const bool positions = operand(0) == kLatitude && operand(1) == kLongitude &&
                             operand(2) == kLatitude && operand(3) == kLongitude;
      return from(positions, expr.op == Op::Distance ? kLength : kAngle);
    }
  }
}

bool isGeometry(Op op) {
  return op == Op::Sin || op == Op::Cos || op == Op::Tan || op == Op::Atan2 || op == Op::Distance ||
         op == Op::Bearing;
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

bool isComparison(Op op) {
  return isOrdering(op) || op == Op::Equal || op == Op::NotEqual;
}

Op negated(Op comparison) {
  switch (comparison) {
    case Op::Less:
      return Op::GreaterEqual;
    case Op::LessEqual:
      return Op::Greater;
    case Op::Greater:
      return Op::LessEqual;
    case Op::GreaterEqual:
      return Op::Less;
    case Op::Equal:
      return Op::NotEqual;
    default:
      return Op::Equal;
  }
}

bool isWindow(TemporalKind kind) {
  return kind != TemporalKind::Became && kind != TemporalKind::Held;
}

const OpInfo& opInfo(Op op) {
  return kOps.at(static_cast<size_t>(op));
}

const OpInfo* findOp(std::string_view text) {
  auto found = std::ranges::find(kOps, text, &OpInfo::text);
  return found == kOps.end() ? nullptr : &*found;
}

size_t opCount() {
  return kOps.size();
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
  const uint32_t count = opInfo(expr.op).operands;
  auto operand = [&](uint32_t i) { return mission[expr.operands.at(i)].type; };
  switch (expr.op) {
    case Op::Constant:
      return expr.type.kind == TypeKind::Bool ? std::nullopt : std::optional(expr.type);
    case Op::Sensor:
      return mission[expr.sensor].type;
    case Op::MissionTime:
    case Op::StateTime:
    case Op::ResumeTime:
    case Op::Age:
      return kTime;
    case Op::True:
    case Op::False:
      return kBool;
    case Op::Temporal:
      return watched(mission, mission[expr.temporal]);
    case Op::Variable:
      return mission[expr.variable].type;
    case Op::Call:
      return called(mission, expr);
    case Op::Not:
    case Op::And:
    case Op::Or:
      return operand(0) == kBool && operand(count - 1) == kBool ? std::optional(kBool)
                                                                : std::nullopt;
    default:
      break;
  }
  if (isGeometry(expr.op)) {
    return geometry(mission, expr);
  }
  if (expr.op == Op::Element) {
    return operand(0) == kNumber ? std::optional(mission[expr.table].type) : std::nullopt;
  }
  if (expr.op == Op::Select) {
    const bool fits =
        operand(0) == kBool && operand(1) == operand(2) && operand(1).kind != TypeKind::Bool;
    return fits ? std::optional(operand(1)) : std::nullopt;
  }
  for (uint32_t i = 0; i < count; ++i) {
    if (operand(i).kind == TypeKind::Bool) {
      return std::nullopt;
    }
  }
  if (expr.op == Op::Known) {
    return kBool;
  }
  if (isComparison(expr.op)) {
    return operand(0) == operand(1) ? std::optional(kBool) : std::nullopt;
  }
  if (expr.op == Op::Clamp && operand(2) != operand(0)) {
    return std::nullopt;
  }
  return arithmetic(expr.op, operand(0), operand(count == 1 ? 0 : 1));
}

}  // namespace glider::ir
