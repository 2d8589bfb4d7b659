// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"
#include "ir/verify/inherited.h"
#include "ir/verify/intervals.h"
#include "platforms/load/platform.h"

#include <optional>
#include <vector>

namespace glider::ir::prove {

/// What all proofs about a mission stand on: the mission, the vehicle, and what follows from them
/// without a solver.
struct ProofContext {
  /// Both outlive this.
  ProofContext(const Mission& mission, const platforms::Platform& platform);

  const Mission& mission;
  const platforms::Platform& platform;
  std::vector<Interval> intervals;  ///< of every expression
  std::vector<Interval> sensors;    ///< of every sensor's reading, SI units
  std::vector<Interval> windows;    ///< of every temporal that is a window
  GreatestFixpoint known;           ///< never unknown
  std::vector<bool> whole;          ///< of every expression: a whole number, exactly
  /// Of every temporal: the variables that it reads and that a list tried before its own may set in
  /// the same tick. It has looked at them before any list, the guards of its own list after.
  std::vector<std::vector<VariableId>> set_since;
  std::optional<SensorId> depth;  ///< the vehicle's own depth, if the mission reads it
  /// Two ticks of the mission are no further apart than this, s: the SBC may have been without
  /// power for as long as the mission allows (`resume within`), any number of times.
  double tick_gap_s;
  /// The same for an SBC whose power is never cut.
  [[nodiscard]] ProofContext withoutPowerCuts() const;

  /// The platform's row of a sensor; null for one that the platform does not have.
  [[nodiscard]] const platforms::PlatformSensor* platformSensor(SensorId id) const {
    return platform.find(mission[id].vehicle_name);
  }
};

/// The sensor of a mission that is the vehicle's own depth; none if the mission does not read it.
std::optional<SensorId> depthSensor(const Mission& mission, const platforms::Platform& platform);

}  // namespace glider::ir::prove
