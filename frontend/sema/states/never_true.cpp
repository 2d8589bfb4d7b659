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
  bool lowest_is = true, highest_is = true;  ///< whether it is one of them

  void raise(double to, bool is) {
    lowest_is = to > lowest ? is : lowest_is && (is || to < lowest);
    lowest = std::max(lowest, to);
  }
  void lower(double to, bool is) {
    highest_is = to < highest ? is : highest_is && (is || to > highest);
    highest = std::min(highest, to);
  }
  [[nodiscard]] bool none() const {
    return lowest > highest || (lowest == highest && !(lowest_is && highest_is));
  }
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

  [[nodiscard]] std::optional<ir::SensorId> never() const {
    for (const auto& [sensor, values] : values_) {
      if (values.none()) {
        return ir::SensorId(sensor);
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
    const bool equal = op == ir::Op::Equal;
    if (equal || op == ir::Op::Greater || op == ir::Op::GreaterEqual) {
      values.raise(*number, op != ir::Op::Greater);
    }
    if (equal || op == ir::Op::Less || op == ir::Op::LessEqual) {
      values.lower(*number, op != ir::Op::Less);
    }
  }

  const ir::Mission& mission_;
  std::map<uint32_t, Values> values_;
};

}  // namespace

std::optional<ir::SensorId> neverTrueFor(const ir::Mission& mission, ir::ExprId condition) {
  ConditionReader reader(mission);
  reader.read(condition);
  return reader.never();
}

}  // namespace glider::frontend
