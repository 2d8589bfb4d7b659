// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"
#include "ir/core/monitor_writer.h"
#include "tests/random_missions/random.h"
#include "tests/random_proofs/scouting.h"

#include <map>
#include <optional>
#include <vector>

namespace glider::random_proofs {

/// Where a mission's waypoints are, and how far from them the prover thinks it may get.
struct Track {
  ir::Position south_west, north_east;
  double off_legs_m = 0;
};

/// What is near to be true of a mission.
struct Bounds {
  Scouted scouted;
  std::optional<double> ends_by;     ///< the prover's bound, s
  std::optional<double> deepest;     ///< the same, m
  std::optional<double> submersion;  ///< the same, s
  /// Of each state that only climbs: from so long after it became current on it is at the surface.
  std::map<uint32_t, double> climbs;
  double tick_gap_s = 0;  ///< the longest
  std::optional<Track> track;
};

/// Random conditions about a mission, which they add as expressions: of readings, clocks,
/// parameters and variables of the mission.
class Conditions {
 public:
  /// All outlive this.
  Conditions(ir::Mission& mission, const Bounds& bounds, random_missions::Random& random);

  ir::ExprId any();
  /// What an assumption may read: readings, mission time and parameters.
  ir::ExprId ofReadings();
  /// Exactly `value`, or a little above or below it.
  double near(double value);
  /// The depth is at most so much, m; of `clock` if no depth is read.
  ir::ExprId depthAtMost(double depth);
  [[nodiscard]] const Bounds& bounds() const { return bounds_; }
  /// Near to a time that matters, s; positive.
  double time();
  ir::ExprId reading(ir::SensorId sensor);
  /// A sensor that is measured in a quantity, but not `not_this`; none if there is none.
  std::optional<ir::SensorId> measured(std::optional<ir::SensorId> not_this);

 private:
  ir::ExprId simple();
  ir::ExprId ofClock();
  ir::ExprId ofDepth();
  ir::ExprId ofVariable(bool parameter);
  ir::ExprId ofSensor();
  ir::ExprId compare(ir::Op op, ir::ExprId a, double b);
  ir::ExprId clock(ir::Op op);

  ir::Mission& m_;
  const Bounds& bounds_;
  random_missions::Random& random_;
  ir::MonitorWriter write_;
  std::vector<double> named_;  ///< times that the mission names, s
};

}  // namespace glider::random_proofs
