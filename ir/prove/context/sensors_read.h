// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"
#include "ir/core/walk.h"

#include <vector>

namespace glider::ir::prove {

/// Calls `visit` with each sensor whose reading or age an expression reads, also in what its
/// temporals watch; a sensor may come several times.
template <typename Visit>
void forEachSensorRead(const Mission& mission, ExprId expression, Visit visit) {
  std::vector<ExprId> open{expression};
  while (!open.empty()) {
    const ExprId root = open.back();
    open.pop_back();
    forEachIn(mission, root, [&](const Expr& e) {
      if (e.op == Op::Sensor || e.op == Op::Age) {
        visit(e.sensor);
      } else if (e.op == Op::Temporal) {
        open.push_back(mission[e.temporal].operand);  // what is watched comes before: this ends
      }
    });
  }
}

}  // namespace glider::ir::prove
