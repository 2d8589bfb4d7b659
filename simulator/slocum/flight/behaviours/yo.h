// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/slocum/flight/behaviours/depth_leg.h"
#include "simulator/slocum/flight/behaviours/started.h"

namespace glider::simulator {

/// Dives and climbs in turn.
class Yo final : public StartedBehaviour {
 public:
  explicit Yo(const BehaviourSource& source);
  [[nodiscard]] bool flies() const override { return true; }
  void tell(double time_s, Journal& journal) override;

 protected:
  void begin(const Situation& situation) override;
  Outcome fly(const Situation& situation, Commands& commands) override;

 private:
  WhenCondition stop_;
  DepthLeg dive_, climb_;
  enum class Begins : uint8_t { Climbing, Diving, Continuing } begins_;  ///< start_diving
  Argument half_cycles_to_do_;
  DepthLeg* leg_ = nullptr;
  int half_cycles_ = 0;
  std::vector<News> news_;
};

}  // namespace glider::simulator
