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
constexpr Type kTime{TypeKind::Quantity, support::dimension::time};

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
      return quantities ? quantity(support::quotient(a.dimension, b.dimension)) : std::nullopt;
    default:  // Negate, Abs, Add, Subtract, Min, Max, Clamp
      return a == b ? std::optional(a) : std::nullopt;
  }
}

bool comparison(Op op) {
  return op == Op::Less || op == Op::LessEqual || op == Op::Greater || op == Op::GreaterEqual ||
         op == Op::Equal || op == Op::NotEqual;
}

}  // namespace

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
    case Op::Not:
    case Op::And:
    case Op::Or:
      return operand(0) == kBool && operand(count - 1) == kBool ? std::optional(kBool)
                                                                : std::nullopt;
    default:
      break;
  }
  for (uint32_t i = 0; i < count; ++i) {
    if (operand(i).kind == TypeKind::Bool) {
      return std::nullopt;
    }
  }
  if (expr.op == Op::Known) {
    return kBool;
  }
  if (comparison(expr.op)) {
    return operand(0) == operand(1) ? std::optional(kBool) : std::nullopt;
  }
  if (expr.op == Op::Clamp && operand(2) != operand(0)) {
    return std::nullopt;
  }
  return arithmetic(expr.op, operand(0), operand(count == 1 ? 0 : 1));
}

}  // namespace glider::ir
