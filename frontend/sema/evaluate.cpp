// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/evaluate.h"

#include "ir/core/ops.h"
#include "ir/core/truth.h"
#include "ir/eval/arithmetic.h"

#include <array>

namespace glider::frontend {
namespace {

double asNumber(ir::Truth truth) {
  if (truth == ir::Truth::Unknown) {
    return ir::kUnknown;
  }
  return truth == ir::Truth::True ? 1.0 : 0.0;
}

ir::Truth asTruth(double condition) {
  return ir::isKnown(condition) ? ir::truth(condition != 0) : ir::Truth::Unknown;
}

double apply(ir::Op op, double a, double b, double c) {
  switch (op) {
    case ir::Op::Negate:
    case ir::Op::Abs:
    case ir::Op::Sqrt:
      return ir::unary(op, a);
    case ir::Op::Add:
    case ir::Op::Subtract:
    case ir::Op::Multiply:
    case ir::Op::Divide:
    case ir::Op::Min:
    case ir::Op::Max:
      return ir::binary(op, a, b);
    case ir::Op::Clamp:
      return ir::clamp(a, b, c);
    case ir::Op::Known:
      return asNumber(ir::truth(ir::isKnown(a)));
    case ir::Op::Not:
      return asNumber(ir::logicalNot(asTruth(a)));
    case ir::Op::And:
      return asNumber(ir::logicalAnd(asTruth(a), asTruth(b)));
    case ir::Op::Or:
      return asNumber(ir::logicalOr(asTruth(a), asTruth(b)));
    default:
      return asNumber(ir::compare(op, a, b));
  }
}

}  // namespace

std::optional<double> evaluate(const ir::Mission& mission, ir::ExprId id) {
  const ir::Expr& expr = mission[id];
  switch (expr.op) {
    case ir::Op::Constant:
      return expr.number;
    case ir::Op::True:
    case ir::Op::False:
      return asNumber(ir::truth(expr.op == ir::Op::True));
    case ir::Op::Sensor:
    case ir::Op::Age:
    case ir::Op::MissionTime:
    case ir::Op::StateTime:
    case ir::Op::ResumeTime:
    case ir::Op::Variable:
    case ir::Op::Temporal:
      return std::nullopt;
    default:
      break;
  }
  std::array<double, 3> values{};
  for (size_t i = 0; i < ir::opInfo(expr.op).operands; ++i) {
    const std::optional<double> value = evaluate(mission, expr.operands[i]);
    if (!value) {
      return std::nullopt;
    }
    values[i] = *value;
  }
  return apply(expr.op, values[0], values[1], values[2]);
}

}  // namespace glider::frontend
