// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/slocum/flight/behaviours/depth_leg.h"
#include "simulator/slocum/flight/behaviours/started.h"

#include <string>
#include <vector>

namespace glider::simulator {

/// Flies to a depth and drifts there with a pump that is corrected in small steps, for
/// stop_when_hover_for.
class DriftAtDepth final : public StartedBehaviour {
 public:
  explicit DriftAtDepth(const BehaviourSource& source);
  [[nodiscard]] bool flies() const override { return true; }
  void tell(double time_s, Journal& journal) override;

 protected:
  void begin(const Situation& situation) override;
  Outcome fly(const Situation& situation, Commands& commands) override;

 private:
  [[nodiscard]] bool within(const Situation& situation) const;
  void correct(const Situation& situation);
  void aim(const Situation& situation);

  Argument target_m_, target_altitude_m_, deadband_m_, start_distance_m_, hover_for_s_, step_cc_,
      delay_s_;
  PitchSource pitch_;
  DepthLeg dive_, climb_;
  bool hovers_ = false;
  double aim_m_ = 0;    ///< the depth to drift at
  double water_m_ = 0;  ///< the newest depth of the water; NaN: not known
  double hovering_since_s_ = 0, corrected_s_ = 0, pump_cc_ = 0;
  std::vector<News> news_;
};

}  // namespace glider::simulator
