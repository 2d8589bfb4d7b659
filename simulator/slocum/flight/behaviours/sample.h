// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/slocum/flight/behaviour.h"
#include "simulator/slocum/flight/behaviours/source.h"

#include <limits>

namespace glider::simulator {

/// Orders readings of an instrument of the science bay, or of all, in some states of the vehicle.
class Sample final : public Behaviour {
 public:
  explicit Sample(const BehaviourSource& source);

 protected:
  [[nodiscard]] bool starts(const Situation&, const Commands&) const override { return true; }
  Outcome fly(const Situation& situation, Commands& commands) override;

 private:
  void countYos(const Situation& situation);
  [[nodiscard]] bool isInState(const Situation& situation) const;
  [[nodiscard]] bool isYoToSample() const;
  [[nodiscard]] double period(const Situation& situation) const;

  int sensor_type_;
  Argument states_, after_s_, intersample_s_, nth_yo_, intersample_m_, least_depth_m_,
      most_depth_m_;
  int yo_ = 0;  ///< the first dive begins number 1
  bool dives_ = false;
  double in_state_s_ = -std::numeric_limits<double>::infinity();  ///< when it last was
};

}  // namespace glider::simulator
