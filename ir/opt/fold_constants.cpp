// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/core/ops.h"
#include "ir/eval/arithmetic.h"
#include "ir/opt/passes.h"
#include "ir/opt/replace.h"

#include <array>
#include <cmath>
#include <optional>

namespace glider::ir::opt {
namespace {

/// Folds in the order of the vector, so that operands are folded before their users.
class Folder {
 public:
  explicit Folder(Mission& mission)
      : m_(mission), by_(mission.exprs.size()), calls_(mission.exprs.size()) {}

  void run() {
    for (uint32_t i = 0; i < by_.size(); ++i) {
      by_[i] = {i};
      Expr& expr = m_.exprs[i];
      calls_[i] = expr.op == Op::Call;
      for (ExprId& operand : expr.operands) {
        operand = operand.valid() ? by_[operand.index] : operand;
        calls_[i] = calls_[i] || (operand.valid() && calls_[operand.index]);
      }
      fold({i});
    }
    replace(m_, by_);
  }

 private:
  [[nodiscard]] const Expr& operand(const Expr& expr, size_t i) const {
    return m_[expr.operands.at(i)];
  }

  void fold(ExprId id) {
    const Expr& expr = m_[id];
    if (expr.op == Op::Call) {
      return;
    }
    if (const auto same = sameAs(expr)) {
      by_[id.index] = *same;
    } else if (const auto value = truthOf(expr); value && *value != Truth::Unknown) {
      become(id, *value == Truth::True ? Op::True : Op::False, 0);
    } else if (const auto number = numberOf(expr); number && isKnown(*number)) {
      become(id, Op::Constant, *number);
    }
  }

  void become(ExprId id, Op op, double number) {
    Expr& expr = m_.exprs[id.index];
    expr.op = op;
    expr.number = number;
    expr.operands = {};
    expr.table = {};
  }

  /// The operand that `expr` is equal to.
  [[nodiscard]] std::optional<ExprId> sameAs(const Expr& expr) const {
    auto is = [&](size_t i, Op op) { return operand(expr, i).op == op; };
    if (expr.op == Op::Not && is(0, Op::Not)) {
      return operand(expr, 0).operands[0];
    }
    if (expr.op == Op::And || expr.op == Op::Or) {
      const Op neutral = expr.op == Op::And ? Op::True : Op::False;
      const Op ruling = expr.op == Op::And ? Op::False : Op::True;
      for (size_t i = 0; i < 2; ++i) {
        if (is(i, neutral)) {
          return expr.operands.at(1 - i);
        }
        // A call in the other operand must be made even if its result does not matter.
        if (is(i, ruling) && !calls_[expr.operands.at(1 - i).index]) {
          return expr.operands.at(i);
        }
      }
      if (expr.operands[0] == expr.operands[1]) {
        return expr.operands[0];
      }
    }
    return std::nullopt;
  }

  /// The operands' numbers if all are constants.
  [[nodiscard]] std::optional<std::array<double, 4>> constants(const Expr& expr) const {
    std::array<double, 4> numbers{};
    const uint32_t count = operandCount(expr);
    for (uint32_t i = 0; i < count; ++i) {
      if (operand(expr, i).op != Op::Constant) {
        return std::nullopt;
      }
      numbers.at(i) = operand(expr, i).number;
    }
    return count == 0 ? std::nullopt : std::optional(numbers);
  }

  [[nodiscard]] std::optional<double> numberOf(const Expr& expr) const {
    const auto n = constants(expr);
    if (!n || expr.type.kind == TypeKind::Bool) {
      return std::nullopt;
    }
    switch (groupOf(expr.op)) {
      case OpGroup::Unary:
        return unary(expr.op, (*n)[0]);
      case OpGroup::Binary:
        return binary(expr.op, (*n)[0], (*n)[1]);
      case OpGroup::Clamp:
        return clamp((*n)[0], (*n)[1], (*n)[2]);
      case OpGroup::Element:
        return element(m_[expr.table], (*n)[0]);
      case OpGroup::Function:  // runtime/numbers computes it when the mission flies
      case OpGroup::Select:
      case OpGroup::Constant:
      case OpGroup::Sensor:
      case OpGroup::Clock:
      case OpGroup::Age:
      case OpGroup::Variable:
      case OpGroup::Temporal:
      case OpGroup::Call:
      case OpGroup::Truth:
      case OpGroup::Comparison:
      case OpGroup::Known:
      case OpGroup::Logic:
        break;
    }
    return std::nullopt;
  }

  [[nodiscard]] std::optional<Truth> truthOf(const Expr& expr) const {
    if (expr.op == Op::Not && groupOf(operand(expr, 0).op) == OpGroup::Truth) {
      return truth(operand(expr, 0).op == Op::False);
    }
    if (expr.op == Op::Known && constants(expr)) {
      return Truth::True;
    }
    const auto n = isComparison(expr.op) ? constants(expr) : std::nullopt;
    return n ? std::optional(compare(expr.op, (*n)[0], (*n)[1])) : std::nullopt;
  }

  Mission& m_;
  std::vector<ExprId> by_;
  std::vector<bool> calls_;  ///< whether a C function is called in it
};

}  // namespace

void foldConstants(Mission& mission) {
  Folder(mission).run();
}

}  // namespace glider::ir::opt
