// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/flight/behaviour.h"

#include <string>

namespace glider::simulator {

/// start_when, when_secs and when_wpt_dist of `block`.
inline When startCondition(const slocum::BehaviourBlock& block) {
  return {static_cast<int>(block.value("start_when")), block.value("when_secs"),
          block.value("when_wpt_dist")};
}

inline When stopCondition(const slocum::BehaviourBlock& block) {
  return {static_cast<int>(block.value("stop_when")), block.value("when_secs"),
          block.value("when_wpt_dist")};
}

/// use_pitch and pitch_value of `block` behind `prefix` ("d_", "c_"): 1 battery position, 2
/// calibration curve, 3 servo.
inline PitchCommand pitchCommand(const slocum::BehaviourBlock& block, const std::string& prefix) {
  const int use = static_cast<int>(block.value(prefix + "use_pitch"));
  const auto mode = use == 1   ? PitchCommand::Mode::BatteryPosition
                    : use == 2 ? PitchCommand::Mode::Curve
                               : PitchCommand::Mode::Servo;
  return {mode, block.value(prefix + "pitch_value")};
}

}  // namespace glider::simulator
