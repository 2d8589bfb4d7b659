// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/slocum/flight/behaviour.h"
#include "simulator/slocum/flight/behaviours/source.h"

#include <string>

namespace glider::simulator {

/// dive_to or climb_to, also as a sub-behaviour of a yo: one half cycle to a depth or an altitude.
class DepthLeg {
 public:
  enum class Direction : uint8_t { Dive, Climb };

  /// Reads the arguments behind `prefix`: `d_` or `c_` of a yo, nothing of dive_to and climb_to.
  DepthLeg(const BehaviourSource& source, Direction direction, const std::string& prefix);

  void begin(const Situation& situation);
  /// True when the leg is over. While `overridden` only truly reaching the target counts: the
  /// vehicle's motion is then not caused by this leg.
  bool over(const Situation& situation, bool overridden);
  void command(Commands& commands) const;
  [[nodiscard]] const char* name() const {
    return direction_ == Direction::Dive ? "dive_to" : "climb_to";
  }
  /// Why it is over.
  [[nodiscard]] const std::string& why() const { return why_; }

 private:
  [[nodiscard]] bool reached(const Situation& situation);
  [[nodiscard]] bool stuck(const Situation& situation);

  /// The vehicle clips the target of a dive to the depth in which it may work.
  [[nodiscard]] double targetDepth() const;

  Direction direction_;
  const MissionVariables& variables_;
  Argument given_depth_, target_altitude_, pump_cc_, hover_for_s_, stalled_for_s_;
  PitchSource pitch_;
  double moving_s_ = 0;   ///< when it last moved
  double deepest_s_ = 0;  ///< when it last gained depth or height
  double best_depth_ = 0;
  std::string why_;
};

}  // namespace glider::simulator
