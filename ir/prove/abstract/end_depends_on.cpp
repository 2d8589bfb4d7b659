// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/abstract/end_depends_on.h"

#include "ir/prove/abstract/end_bound.h"
#include "ir/prove/context/sensors_awaited.h"

namespace glider::ir::prove {
namespace {

/// More sensors in guards are not tried: each takes a search for the end.
constexpr size_t kMostTried = 12;

class Sensors {
 public:
  explicit Sensors(const Mission& mission) : m_(mission), awaited_(mission.sensors.size(), false) {}

  /// The cases that lead away.
  void add(const std::vector<Case>& cases) {
    for (const Case& c : cases) {
      if (c.transition != Transition::Stay) {
        add(c.guard);
      }
    }
  }

  [[nodiscard]] std::vector<SensorId> all() const {
    std::vector<SensorId> found;
    for (uint32_t i = 0; i < awaited_.size(); ++i) {
      if (awaited_[i]) {
        found.push_back({i});
      }
    }
    return found;
  }

 private:
  void add(ExprId guard) {
    forEachSensorAwaited(m_, guard, [&](SensorId id) { awaited_[id.index] = true; });
  }

  const Mission& m_;
  std::vector<bool> awaited_;
};

/// Whether the mission ends by its clocks if the sensor reports nothing: none of its values is in
/// range.
bool endsWithout(const ProofContext& proof_context, SensorId sensor) {
  Mission silent = proof_context.mission;
  silent.sensors[sensor.index].lowest = 1;
  silent.sensors[sensor.index].highest = 0;
  const ProofContext without(silent, proof_context.platform);
  return boundOf(without.withoutPowerCuts(), kLongestMission, Goal::Exit).by.has_value();
}

}  // namespace

std::vector<SensorId> endDependsOn(const ProofContext& proof_context,
                                   const std::vector<StateId>& states) {
  const Mission& m = proof_context.mission;
  Sensors everywhere(m);
  everywhere.add(m.always);
  for (const State& state : m.states) {
    everywhere.add(state.cases);
  }
  std::vector<SensorId> found = everywhere.all();
  if (found.size() > kMostTried) {
    found.clear();
  }
  std::erase_if(found, [&](SensorId id) { return !endsWithout(proof_context, id); });
  if (found.empty()) {
    Sensors here(m);
    for (const StateId state : states) {
      here.add(m[state].cases);
    }
    found = here.all();
  }
  return found;
}

}  // namespace glider::ir::prove
