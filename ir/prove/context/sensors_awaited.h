// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"
#include "ir/core/ops.h"

#include <unordered_set>
#include <vector>

namespace glider::ir::prove {

/// Whether an expression is such as `known(x) ? x : y`, for a sensor x.
inline bool isSensorOrElse(const Mission& mission, const Expr& e) {
  if (e.op != Op::Select) {
    return false;
  }
  const Expr& asked = mission[e.operands[0]];
  const Expr& first = mission[e.operands[1]];
  return asked.op == Op::Known && first.op == Op::Sensor &&
         mission[asked.operands[0]].op == Op::Sensor &&
         mission[asked.operands[0]].sensor == first.sensor;
}

/// The same with a constant y: x may stay unknown.
inline bool hasDefault(const Mission& mission, const Expr& e) {
  return isSensorOrElse(mission, e) && mission[e.operands[2]].op == Op::Constant;
}

/// Calls `visit` with each part of an expression without which it, or what its temporals watch, may
/// stay unknown. `visit` returns whether to go on into the part.
template <typename Visit>
void forEachPartAwaited(const Mission& mission, ExprId expression, Visit visit) {
  std::vector<ExprId> open{expression};
  std::unordered_set<uint32_t> seen;
  while (!open.empty()) {
    const ExprId id = open.back();
    open.pop_back();
    if (!id.valid() || !seen.insert(id.index).second) {
      continue;
    }
    const Expr& e = mission[id];
    if (!visit(e)) {
      continue;
    }
    if (e.op == Op::Temporal) {
      const Temporal& watched = mission[e.temporal];
      open.insert(open.end(), {watched.along, watched.duration, watched.operand});
    } else if (!hasDefault(mission, e)) {
      open.insert(open.end(), e.operands.begin(), e.operands.begin() + operandCount(e));
    }
  }
}

/// Calls `visit` with each sensor without whose readings an expression, or what its temporals
/// watch, may stay unknown; a sensor may come several times. The variation in `90 deg magnetic`
/// is not one, the state of the vehicle that tells legs apart is.
template <typename Visit>
void forEachSensorAwaited(const Mission& mission, ExprId expression, Visit visit) {
  forEachPartAwaited(mission, expression, [&](const Expr& e) {
    if (e.op == Op::Sensor || e.op == Op::Age) {
      visit(e.sensor);
    }
    return true;
  });
}

/// The same, without those of which it only asks whether there is a reading, or how old it is.
template <typename Visit>
void forEachReadingAwaited(const Mission& mission, ExprId expression, Visit visit) {
  forEachPartAwaited(mission, expression, [&](const Expr& e) {
    if (e.op == Op::Sensor) {
      visit(e.sensor);
    }
    return e.op != Op::Known && e.op != Op::Age;
  });
}

}  // namespace glider::ir::prove
