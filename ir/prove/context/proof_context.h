// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"
#include "ir/verify/inherited.h"
#include "ir/verify/intervals.h"
#include "ir/worlds/worlds.h"
#include "platforms/load/platform.h"

#include <limits>
#include <optional>
#include <vector>

namespace glider::ir::prove {

/// The basis of all proofs about a mission: the mission, the vehicle, and what follows from them
/// without a solver.
struct ProofContext {
  /// Both outlive this.
  ProofContext(const Mission& mission, const platforms::Platform& platform);
  /// About a world, which outlives this.
  explicit ProofContext(const WrittenWorld& world) : ProofContext(world.mission, world.platform) {}
  explicit ProofContext(const WidestWorld& world) : ProofContext(world.mission, world.platform) {}
  explicit ProofContext(const AssumedWorld& world) : ProofContext(world.mission, world.platform) {}
  /// The same for a mission of which every trace has ended by mission time `latest`, s: what that
  /// says of clocks holds for all that is computed from them.
  [[nodiscard]] ProofContext endingBy(double latest) const;

  const Mission& mission;
  const platforms::Platform& platform;
  std::vector<Interval> intervals;  ///< of every expression
  std::vector<Interval> sensors;    ///< of every sensor's reading, SI units
  std::vector<Interval> windows;    ///< of every temporal that is a window
  GreatestFixpoint known;           ///< never unknown
  std::vector<bool> whole;          ///< of every expression: whether it is exactly a whole number
  /// Of every expression: whether it is always a mission time, of this tick or an earlier one, or
  /// 0.
  std::vector<bool> mission_times;
  /// For every temporal: the variables that it reads and that a list tried before its own may set
  /// in the same tick. The temporal reads them before any list is tried, the guards of its own list
  /// afterwards.
  std::vector<std::vector<VariableId>> set_since;
  std::optional<SensorId> depth;  ///< the vehicle's own depth, if the mission reads it
  /// The longest time between two ticks of the mission, s: the SBC may have been without power for
  /// as long as the mission allows (`resume within`), any number of times.
  double tick_gap_s;
  /// No tick comes at a later mission time, s.
  double latest_s = std::numeric_limits<double>::max();
  /// The same of a mission that differs from this one, and outlives the result.
  [[nodiscard]] ProofContext ofVersion(const Mission& changed) const;
  /// The same for an SBC whose power is never cut.
  [[nodiscard]] ProofContext withoutPowerCuts() const;
  /// The same while the vehicle's depth is never unknown.
  [[nodiscard]] ProofContext withDepthKnown() const;

  /// A value that a sensor measures, with its unit: "0.75 ug/L".
  [[nodiscard]] std::string readingText(SensorId id, double value) const;
  /// The platform's row of a sensor; null if the platform does not have it.
  [[nodiscard]] const platforms::PlatformSensor* platformSensor(SensorId id) const {
    return platform.find(mission[id].vehicle_name);
  }

 private:
  ProofContext(const Mission& mission, const platforms::Platform& platform, double latest);
};

}  // namespace glider::ir::prove
