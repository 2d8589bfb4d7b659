// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/slocum/flight/dynamic_control.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace glider::simulator {
namespace {

// The vendor's calibration curve: pitch = slope * battery position + offset.
constexpr double kCurveSlope = -1.2565;  // rad/in
constexpr double kCurveOffset = 0.055;   // rad
// Pitch servo: deadband, largest step and range of periods as in the vehicle. Its gain there is 3
// in/rad; half of that suits this hull, which tilts more slowly than its battery moves.
constexpr double kServoGain = 1.5;         // in/rad
constexpr double kServoDeadband = 0.0524;  // rad
constexpr double kServoStep = 0.2;         // in
constexpr double kServoPeriod = 16;        // s
constexpr double kInflection = 24;  // s, for pump, battery and hull before the servo corrects
constexpr double kSettles = 12;     // s, for the hull after an inflection
// Heading autopilot, as in the vehicle: PD on heading, in shares of the fin's range, with a
// deadband.
constexpr double kHeadingGain = 1.5;      // per rad
constexpr double kHeadingRateGain = 4.0;  // per rad/s
constexpr double kHeadingDeadband = 0.087;

double wrapped(double angle) {
  return std::remainder(angle, 2 * std::numbers::pi);
}

}  // namespace

/// The battery's position at the beginning of a pitch command.
double DynamicControl::batteryFor(const PitchCommand& command, const Vehicle& vehicle) {
  const double wanted = command.mode == PitchCommand::Mode::BatteryPosition
                            ? command.value
                            : (command.value - kCurveOffset) / kCurveSlope;
  return std::clamp(wanted, -vehicle.limits().pitch_battery_in, vehicle.limits().pitch_battery_in);
}

void DynamicControl::holdPitch(const PitchCommand& command, const Measured& m, Vehicle& vehicle) {
  if (command.mode == PitchCommand::Mode::Ignore) {
    return;
  }
  const bool servo = command.mode == PitchCommand::Mode::Servo;
  if (command != pitch_in_force_) {
    pitch_in_force_ = command;
    battery_in_ = batteryFor(command, vehicle);
    next_servo_s_ = m.time_s + kInflection;
  } else if (servo && m.time_s >= next_servo_s_) {
    const double error = command.value - m.pitch;
    if (std::fabs(error) > kServoDeadband) {
      battery_in_ -= std::clamp(kServoGain * error, -kServoStep, kServoStep);
    }
    next_servo_s_ = m.time_s + kServoPeriod;
  }
  battery_in_ = std::clamp(battery_in_, -vehicle.limits().pitch_battery_in,
                           vehicle.limits().pitch_battery_in);
  vehicle.commandBatteryPosition(battery_in_);
}

void DynamicControl::holdHeading(const HeadingCommand& command, const Measured& m, double seconds,
                                 Vehicle& vehicle) {
  const double rate = heading_known_ ? wrapped(m.heading - last_heading_) / seconds : 0;
  last_heading_ = m.heading;
  heading_known_ = !std::isnan(m.heading);
  if (command.mode == HeadingCommand::Mode::Ignore) {
    return;
  }
  if (command.mode == HeadingCommand::Mode::Fin) {
    heading_value_ = std::numeric_limits<double>::quiet_NaN();
    vehicle.commandFin(command.value_rad);
    return;
  }
  heading_value_ =
      command.mode == HeadingCommand::Mode::Waypoint ? m.waypoint_bearing : command.value_rad;
  const double error = wrapped(heading_value_ - m.heading);
  if (std::isnan(error)) {
    vehicle.commandFin(0);  // without a heading or a position: straight ahead
    return;
  }
  const double wanted = std::fabs(error) > kHeadingDeadband ? kHeadingGain * error : 0;
  vehicle.commandFin(vehicle.limits().fin_rad *
                     std::clamp(wanted - kHeadingRateGain * rate, -1.0, 1.0));
}

/// Begins an inflection if the commands call for one, and carries on with one that has begun.
void DynamicControl::turn(const Commands& commands, const Measured& m, Vehicle& vehicle) {
  if (commands.at_once) {
    inflection_ = {};
    return;
  }
  if (inflection_.active()) {
    inflection_.cycle(vehicle);
    next_servo_s_ = m.time_s + kSettles;
  }
  const PitchCommand& pitch = *commands.pitch;
  const bool both = pitch.mode != PitchCommand::Mode::Ignore && !std::isnan(*commands.pump_cc);
  if (inflection_.active() || !both || pitch == pitch_in_force_) {
    return;
  }
  const Inflection::Targets to{pump_cc_, batteryFor(pitch, vehicle)};
  if (Inflection::isNeeded(to, vehicle)) {
    pitch_in_force_ = pitch;
    battery_in_ = to.battery_in;
    inflection_.begin(to, vehicle);
    inflection_.cycle(vehicle);
  }
}

void DynamicControl::cycle(const Commands& commands, const Measured& measured, double seconds,
                           Vehicle& vehicle) {
  holdHeading(*commands.heading, measured, seconds, vehicle);
  const PitchCommand& pitch = *commands.pitch;
  if (pitch.mode != PitchCommand::Mode::Ignore) {
    const bool battery = pitch.mode == PitchCommand::Mode::BatteryPosition;
    pitch_value_ = battery ? std::numeric_limits<double>::quiet_NaN() : pitch.value;
  }
  const bool pumps = !std::isnan(*commands.pump_cc);
  if (pumps) {
    pump_cc_ = std::clamp(*commands.pump_cc, -vehicle.limits().pump_cc, vehicle.limits().pump_cc);
  }
  turn(commands, measured, vehicle);
  if (inflection_.active()) {
    return;
  }
  holdPitch(pitch, measured, vehicle);
  if (pumps) {
    vehicle.commandPump(pump_cc_);
  }
}

}  // namespace glider::simulator
