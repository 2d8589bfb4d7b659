// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/expressions/evaluate.h"

#include "ir/eval/arithmetic.h"
#include "ir/eval/evaluate.h"

namespace glider::frontend {

std::optional<double> evaluate(const ir::Mission& mission, ir::ExprId id) {
  bool constant = true;
  const auto leaf = [&](const ir::Expr& expr, std::span<const double>) -> ir::Value {
    constant = false;
    return ir::asValue(ir::kUnknown, expr.type);
  };
  const double number = ir::asNumber(ir::evaluate(mission, id, leaf));
  return constant ? std::optional(number) : std::nullopt;
}

}  // namespace glider::frontend
