// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/evaluate.h"

#include <cfloat>
#include <cmath>
#include <limits>

namespace glider::frontend {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

double settle(double value) {
  if (!std::isfinite(value)) {
    return kUnknown;
  }
  return std::fabs(value) <= DBL_MIN ? 0.0 : value;
}

double truth(bool value) {
  return value ? 1.0 : 0.0;
}

double logical(ir::Op op, double a, double b) {
  // The value that decides alone: false for `and`, true for `or`.
  const double decisive = op == ir::Op::And ? 0.0 : 1.0;
  if (a == decisive || b == decisive) {
    return decisive;
  }
  return std::isnan(a) || std::isnan(b) ? kUnknown : 1.0 - decisive;
}

double strict(ir::Op op, double a, double b, double c) {
  switch (op) {
    case ir::Op::Negate:
      return -a;
    case ir::Op::Abs:
      return std::fabs(a);
    case ir::Op::Sqrt:
      return settle(std::sqrt(a));
    case ir::Op::Add:
      return settle(a + b);
    case ir::Op::Subtract:
      return settle(a - b);
    case ir::Op::Multiply:
      return settle(a * b);
    case ir::Op::Divide:
      return settle(a / b);
    case ir::Op::Min:
      return b < a ? b : a;
    case ir::Op::Max:
      return a < b ? b : a;
    case ir::Op::Clamp:
      return a < b ? b : c < a ? c : a;
    case ir::Op::Less:
      return truth(a < b);
    case ir::Op::LessEqual:
      return truth(a <= b);
    case ir::Op::Greater:
      return truth(a > b);
    case ir::Op::GreaterEqual:
      return truth(a >= b);
    case ir::Op::Equal:
      return truth(a == b);
    case ir::Op::NotEqual:
      return truth(a != b);
    case ir::Op::Not:
      return 1.0 - a;
    default:
      return kUnknown;
  }
}

size_t operandCount(ir::Op op) {
  switch (op) {
#define OP(name, text, operands, result) \
  case ir::Op::name:                     \
    return operands;
#include "ir/core/ops.def"
#undef OP
  }
  return 0;
}

}  // namespace

std::optional<double> evaluate(const ir::Mission& mission, ir::ExprId id) {
  const ir::Expr& expr = mission[id];
  switch (expr.op) {
    case ir::Op::Constant:
      return expr.number;
    case ir::Op::True:
    case ir::Op::False:
      return truth(expr.op == ir::Op::True);
    case ir::Op::Sensor:
    case ir::Op::Age:
    case ir::Op::MissionTime:
    case ir::Op::StateTime:
    case ir::Op::ResumeTime:
      return std::nullopt;
    default:
      break;
  }
  double values[3] = {0, 0, 0};
  bool unknown = false;
  for (size_t i = 0; i < operandCount(expr.op); ++i) {
    const std::optional<double> value = evaluate(mission, expr.operands[i]);
    if (!value) {
      return std::nullopt;
    }
    values[i] = *value;
    unknown = unknown || std::isnan(*value);
  }
  if (expr.op == ir::Op::Known) {
    return truth(!unknown);
  }
  if (expr.op == ir::Op::And || expr.op == ir::Op::Or) {
    return logical(expr.op, values[0], values[1]);
  }
  return unknown ? kUnknown : strict(expr.op, values[0], values[1], values[2]);
}

}  // namespace glider::frontend
