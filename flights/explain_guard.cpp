// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "flights/explain_guard.h"

#include "support/one_line.h"

#include <algorithm>

namespace glider::flights {
namespace {

/// Adds the sensors that `root` reads, in the order of their first use; also those that a `held`, a
/// `became` or a window in it observes.
void addSensors(const ir::Mission& mission, ir::ExprId root, std::vector<uint16_t>& sensors) {
  std::vector<ir::ExprId> open = {root};
  while (!open.empty()) {
    const ir::Expr& expr = mission[open.back()];
    open.pop_back();
    if (expr.sensor.valid()) {
      const uint16_t id = mission[expr.sensor].id;
      if (std::ranges::find(sensors, id) == sensors.end()) {
        sensors.push_back(id);
      }
    }
    if (expr.temporal.valid()) {
      open.push_back(mission[expr.temporal].operand);
    }
    for (auto operand = expr.operands.rbegin(); operand != expr.operands.rend(); ++operand) {
      if (operand->valid()) {
        open.push_back(*operand);
      }
    }
  }
}

}  // namespace

simulator::GuardText explainGuard(const compiler::Optimised& of, uint32_t list, uint32_t state,
                                  uint32_t fired_case) {
  const ir::Mission& mission = of.mission;
  simulator::GuardText text;
  if (state >= mission.states.size()) {
    return text;
  }
  const bool always = list == static_cast<uint32_t>(ir::ListKind::Always);
  const std::vector<ir::Case>& cases = always ? mission.always : mission.states[state].cases;
  if (fired_case >= cases.size()) {
    return text;
  }
  const ir::ExprId guard = cases[fired_case].guard;
  const support::SourceRange range = mission[guard].range;
  text.guard = range.valid() ? support::conditionOnOneLine(of.sources().text(range)) : "";
  addSensors(mission, guard, text.sensors);
  return text;
}

}  // namespace glider::flights
