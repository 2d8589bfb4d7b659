// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/states/never_true.h"

#include "frontend/sema/expressions/evaluate.h"
#include "ir/core/ops.h"

#include <algorithm>
#include <limits>
#include <map>

namespace glider::frontend {
namespace {

/// The values of a sensor for which the comparisons that were read are true.
struct Values {
  double lowest = -std::numeric_limits<double>::infinity();
  double highest = std::numeric_limits<double>::infinity();
  bool open = false;  ///< one of the ends is not among them

  [[nodiscard]] bool none() const { return lowest > highest || (open && lowest == highest); }
};

/// Reads the comparisons of a condition.
class ConditionReader {
 public:
  explicit ConditionReader(const ir::Mission& mission) : mission_(mission) {}

  void read(ir::ExprId id) {
    const ir::Expr& expr = mission_[id];
    if (expr.op == ir::Op::And) {
      read(expr.operands[0]);
      read(expr.operands[1]);
      return;
    }
    if (ir::groupOf(expr.op) != ir::OpGroup::Comparison) {
      return;
    }
    compare(expr.op, expr.operands[0], expr.operands[1]);
    compare(ir::mirrored(expr.op), expr.operands[1], expr.operands[0]);
  }

  [[nodiscard]] std::optional<NeverTrue> never() const {
    for (const auto& [sensor, values] : values_) {
      if (values.none()) {
        return NeverTrue{ir::SensorId(sensor)};
      }
    }
    return std::nullopt;
  }

 private:
  void compare(ir::Op op, ir::ExprId reading, ir::ExprId limit) {
    const auto number = evaluate(mission_, limit);
    if (mission_[reading].op != ir::Op::Sensor || !number) {
      return;
    }
    Values& values = values_[mission_[reading].sensor.index];
    const bool above = op == ir::Op::Greater || op == ir::Op::GreaterEqual;
    const bool below = op == ir::Op::Less || op == ir::Op::LessEqual;
    if (above || op == ir::Op::Equal) {
      values.lowest = std::max(values.lowest, *number);
    }
    if (below || op == ir::Op::Equal) {
      values.highest = std::min(values.highest, *number);
    }
    values.open = values.open || op == ir::Op::Greater || op == ir::Op::Less;
  }

  const ir::Mission& mission_;
  std::map<uint32_t, Values> values_;
};

}  // namespace

std::optional<NeverTrue> neverTrue(const ir::Mission& mission, ir::ExprId condition) {
  ConditionReader reader(mission);
  reader.read(condition);
  return reader.never();
}

}  // namespace glider::frontend
