// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/hookbeh/bounds.h"

#include "hooks/protocol/numbers.h"
#include "hooks/protocol/steps.h"

namespace glider::hooks {
namespace {

constexpr double kCircleRad = 6.283185307179586;

// Limits are compared in the whole steps in which instructions come: 26 degrees, written as
// 0.453786 rad in a mission file, must not refuse 26 degrees.
int32_t inMillimetres(double metres) {
  return wholeSteps(metres, kMetreSteps);
}
int32_t inAngleSteps(double radians) {
  return wholeSteps(radians, kRadianSteps);
}

/// `pitch` is the steepness in the commanded direction, positive.
bool pitchFits(double pitch, const HookbehArgs& args) {
  return inAngleSteps(pitch) >= inAngleSteps(args.shallowest_pitch_rad) &&
         inAngleSteps(pitch) <= inAngleSteps(args.steepest_pitch_rad);
}

/// A position as ddmm.mmmm. Sixty minutes are accepted: rounding turns 59.99999999 into 60.
bool isAngle(double ddmm, int most_degrees) {
  const double either_side = magnitude(ddmm);
  if (!(either_side <= most_degrees * 100.0)) {
    return false;
  }
  const int degrees = static_cast<int>(either_side / 100.0);
  return either_side - degrees * 100.0 <= 60.0;
}

HookAnswer checkDepth(double depth, const HookbehArgs& args) {
  if (!isFinite(depth) || depth < 0) {
    return HookAnswer::BadCommand;
  }
  return inMillimetres(depth) <= inMillimetres(args.greatest_depth_m) ? HookAnswer::Accepted
                                                                      : HookAnswer::TooDeep;
}

HookAnswer checkSlope(double depth, double steepness, const HookbehArgs& args) {
  const HookAnswer answer = checkDepth(depth, args);
  if (answer != HookAnswer::Accepted) {
    return answer;
  }
  return pitchFits(steepness, args) ? HookAnswer::Accepted : HookAnswer::BadPitch;
}

HookAnswer checkActuators(double pump_cc, double battery_in, const HookbehArgs& args) {
  // The words of the depth and the pitch, in their steps.
  if (!isFinite(pump_cc) ||
      inMillimetres(magnitude(pump_cc)) > inMillimetres(args.greatest_pump_cc)) {
    return HookAnswer::BadPump;
  }
  const bool far = inAngleSteps(magnitude(battery_in)) > inAngleSteps(args.greatest_battery_in);
  return !isFinite(battery_in) || far ? HookAnswer::BadBattery : HookAnswer::Accepted;
}

HookAnswer checkVertical(const Instruction& instruction, const HookbehArgs& args) {
  switch (instruction.vertical) {
    case HookVertical::None:
    case HookVertical::Surface:
      return HookAnswer::Accepted;
    case HookVertical::Descend:
      return checkSlope(instruction.depth_m, -instruction.pitch_rad, args);
    case HookVertical::Ascend:
      return checkSlope(instruction.depth_m, instruction.pitch_rad, args);
    case HookVertical::Hover:
      return checkDepth(instruction.depth_m, args);
    case HookVertical::Actuators:
      return checkActuators(instruction.depth_m, instruction.pitch_rad, args);
  }
  return HookAnswer::BadCommand;
}

HookAnswer checkLateral(const Instruction& instruction, const HookbehArgs& args) {
  switch (instruction.lateral) {
    case HookLateral::Drift:
      return HookAnswer::Accepted;
    case HookLateral::Heading: {
      return inAngleSteps(magnitude(instruction.heading_rad)) <= inAngleSteps(kCircleRad)
                 ? HookAnswer::Accepted
                 : HookAnswer::BadCommand;
    }
    case HookLateral::Waypoint:
      return isAngle(instruction.latitude_ddmm, 90) && isAngle(instruction.longitude_ddmm, 180)
                 ? HookAnswer::Accepted
                 : HookAnswer::NotOnEarth;
    case HookLateral::Fin:
      return inAngleSteps(magnitude(instruction.heading_rad)) <= inAngleSteps(args.greatest_fin_rad)
                 ? HookAnswer::Accepted
                 : HookAnswer::BadFin;
  }
  return HookAnswer::BadCommand;
}

}  // namespace

HookAnswer checkBounds(const Instruction& instruction, const HookbehArgs& args) {
  const HookAnswer vertical = checkVertical(instruction, args);
  return vertical == HookAnswer::Accepted ? checkLateral(instruction, args) : vertical;
}

}  // namespace glider::hooks
