// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/slocum/flight/behaviour.h"
#include "simulator/slocum/flight/mission_variables.h"

namespace glider::simulator {

/// Watches the vehicle's limits and aborts the mission: overdepth, overtime, undervolts,
/// samedepth_for, max_wpt_distance, no_cop_tickle_for. The other limits of a real abend watch what
/// is not simulated.
class Abend final : public Behaviour {
 public:
  explicit Abend(const BehaviourSource& source);
  [[nodiscard]] Abort abort(std::string& why) const override;

 protected:
  [[nodiscard]] bool starts(const Situation&, const Commands&) const override { return true; }
  Outcome fly(const Situation& situation, Commands& commands) override;

 private:
  void watchDepth(const Situation& situation);

  /// The vehicle clips overdepth to the depth in which it may work.
  [[nodiscard]] double overdepth() const;

  const MissionVariables& variables_;
  Argument overdepth_, overtime_, undervolts_, same_depth_for_, waypoint_distance_, untickled_for_;
  double reference_depth_ = 0, reference_since_s_ = 0;
  Abort found_ = Abort::None;
  std::string why_;
};

}  // namespace glider::simulator
