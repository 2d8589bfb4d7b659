// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/opt/drop_requirements.h"

#include "ir/opt/compact.h"

#include <vector>

namespace glider::ir {
namespace {

std::vector<bool> usedSensors(const Mission& mission) {
  std::vector<bool> used(mission.sensors.size());
  auto use = [&](SensorId id) {
    if (id.valid()) {
      used[id.index] = true;
    }
  };
  for (const Expr& expr : mission.exprs) {
    use(expr.sensor);
  }
  for (const Behaviour& behaviour : mission.behaviours) {
    for (const SensorId id : behaviour.reads) {
      use(id);
    }
  }
  if (mission.compass) {
    use(mission.compass->variation);
  }
  return used;
}

void renumberTable(GuardTable& table, const std::vector<uint32_t>& numbers) {
  for (GuardColumn& column : table.columns) {
    if (column.sensor.valid()) {
      column.sensor.index = numbers[column.sensor.index];
    }
  }
}

/// `numbers` are the new ones.
void renumber(Mission& mission, const std::vector<uint32_t>& numbers) {
  for (Expr& expr : mission.exprs) {
    if (expr.sensor.valid()) {
      expr.sensor.index = numbers[expr.sensor.index];
    }
  }
  for (Behaviour& behaviour : mission.behaviours) {
    for (SensorId& id : behaviour.reads) {
      id.index = numbers[id.index];
    }
  }
  if (mission.compass && mission.compass->variation.valid()) {
    SensorId& variation = mission.compass->variation;
    variation.index = numbers[variation.index];
  }
  renumberTable(mission.always_table, numbers);
  for (State& state : mission.states) {
    renumberTable(state.table, numbers);
  }
}

}  // namespace

void dropRequirements(Mission& mission) {
  if (mission.requirements.empty() && mission.assumptions.empty()) {
    return;
  }
  mission.requirements.clear();
  mission.assumptions.clear();
  std::erase_if(mission.variables, [](const Variable& v) { return isOfMonitor(v.kind); });
  opt::compact(mission);
  const std::vector<bool> used = usedSensors(mission);
  std::vector<uint32_t> numbers(used.size());
  std::vector<Sensor> kept;
  for (size_t i = 0; i < used.size(); ++i) {
    numbers[i] = static_cast<uint32_t>(kept.size());
    if (used[i]) {
      kept.push_back(std::move(mission.sensors[i]));
    }
  }
  mission.sensors = std::move(kept);
  renumber(mission, numbers);
}

}  // namespace glider::ir
