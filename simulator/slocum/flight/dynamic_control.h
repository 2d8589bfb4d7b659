// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/slocum/flight/commands.h"
#include "simulator/slocum/flight/inflection.h"
#include "simulator/vehicle/vehicle.h"

namespace glider::simulator {

/// Turns the commands in force into motor positions, cycle by cycle: pitch servo, heading
/// autopilot, pump.
class DynamicControl {
 public:
  struct Measured {
    double time_s, pitch, heading, waypoint_bearing;  ///< both magnetic
  };
  /// One cycle of `seconds`. All three slots are filled. During an inflection pitch and pump are
  /// left to it, unless the commands are `at_once`.
  void cycle(const Commands& commands, const Measured& measured, double seconds, Vehicle& vehicle);

  [[nodiscard]] double pitchCommand() const {
    return pitch_value_;
  }  ///< rad; NaN at a battery position
  [[nodiscard]] double headingCommand() const {
    return heading_value_;
  }  ///< rad; NaN for a fixed fin
  [[nodiscard]] double pumpCommand() const { return pump_cc_; }  ///< within the pump's limits

 private:
  void turn(const Commands& commands, const Measured& measured, Vehicle& vehicle);
  [[nodiscard]] static double batteryFor(const PitchCommand& command, const Vehicle& vehicle);
  void holdPitch(const PitchCommand& command, const Measured& measured, Vehicle& vehicle);
  void holdHeading(const HeadingCommand& command, const Measured& measured, double seconds,
                   Vehicle& vehicle);

  Inflection inflection_;
  PitchCommand pitch_in_force_{PitchCommand::Mode::Servo, 1e9};  ///< none yet
  double battery_in_ = 0, next_servo_s_ = 0;
  double pitch_value_ = 0, heading_value_ = 0, pump_cc_ = 0;
  double last_heading_ = 0;
  bool heading_known_ = false;
};

}  // namespace glider::simulator
