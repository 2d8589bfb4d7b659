// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/hookbeh/bounds.h"

#include "hooks/protocol/numbers.h"
#include "hooks/protocol/steps.h"

static const double kCircleRad = 6.283185307179586;
/// Beyond any limit of a vehicle.
enum { kMostSteps = 2000000000 };

// Limits are compared in the whole steps in which instructions come: 26 degrees, written as
// 0.453786 rad in a mission file, must not refuse 26 degrees.
static int32_t inMillimetres(double metres) {
  return hookWholeSteps(metres, kHookMetreSteps, kMostSteps);
}
static int32_t inAngleSteps(double radians) {
  return hookWholeSteps(radians, kHookRadianSteps, kMostSteps);
}

static HookAnswer checkDepth(double depth, const HookbehArgs* args) {
  if (!hookIsFinite(depth) || depth < 0) {
    return kHookAnswerBadCommand;
  }
  return inMillimetres(depth) <= inMillimetres(args->greatest_depth_m) ? kHookAnswerAccepted
                                                                       : kHookAnswerTooDeep;
}

/// `pitch` is the steepness in the commanded direction, positive.
static bool pitchFits(double pitch, const HookbehArgs* args) {
  return inAngleSteps(pitch) >= inAngleSteps(args->shallowest_pitch_rad) &&
         inAngleSteps(pitch) <= inAngleSteps(args->steepest_pitch_rad);
}

static HookAnswer checkSlope(double depth, double steepness, const HookbehArgs* args) {
  const HookAnswer answer = checkDepth(depth, args);
  if (answer != kHookAnswerAccepted) {
    return answer;
  }
  return pitchFits(steepness, args) ? kHookAnswerAccepted : kHookAnswerBadPitch;
}

static HookAnswer checkActuators(double pump_cc, double battery_in, const HookbehArgs* args) {
  // The words of the depth and the pitch, in their steps.
  if (!hookIsFinite(pump_cc) ||
      inMillimetres(hookMagnitude(pump_cc)) > inMillimetres(args->greatest_pump_cc)) {
    return kHookAnswerBadPump;
  }
  const bool beyond =
      inAngleSteps(hookMagnitude(battery_in)) > inAngleSteps(args->greatest_battery_in);
  return !hookIsFinite(battery_in) || beyond ? kHookAnswerBadBattery : kHookAnswerAccepted;
}

static HookAnswer checkVertical(const HookInstruction* instruction, const HookbehArgs* args) {
  switch (instruction->vertical) {
    case kHookVerticalNone:
    case kHookVerticalSurface:
      return kHookAnswerAccepted;
    case kHookVerticalDescend:
      return checkSlope(instruction->depth_m, -instruction->pitch_rad, args);
    case kHookVerticalAscend:
      return checkSlope(instruction->depth_m, instruction->pitch_rad, args);
    case kHookVerticalHover:
      return checkDepth(instruction->depth_m, args);
    case kHookVerticalActuators:
      return checkActuators(instruction->depth_m, instruction->pitch_rad, args);
  }
  return kHookAnswerBadCommand;
}

/// A position as ddmm.mmmm. Sixty minutes are accepted: rounding turns 59.99999999 into 60.
static bool isAngle(double ddmm, int most_degrees) {
  const double either_side = hookMagnitude(ddmm);
  if (!(either_side <= most_degrees * 100.0)) {
    return false;
  }
  const int degrees = (int)(either_side / 100.0);
  return either_side - degrees * 100.0 <= 60.0;
}

static HookAnswer checkLateral(const HookInstruction* instruction, const HookbehArgs* args) {
  switch (instruction->lateral) {
    case kHookLateralDrift:
      return kHookAnswerAccepted;
    case kHookLateralHeading: {
      return inAngleSteps(hookMagnitude(instruction->heading_rad)) <= inAngleSteps(kCircleRad)
                 ? kHookAnswerAccepted
                 : kHookAnswerBadCommand;
    }
    case kHookLateralWaypoint:
      return isAngle(instruction->latitude_ddmm, 90) && isAngle(instruction->longitude_ddmm, 180)
                 ? kHookAnswerAccepted
                 : kHookAnswerNotOnEarth;
    case kHookLateralFin:
      return inAngleSteps(hookMagnitude(instruction->heading_rad)) <=
                     inAngleSteps(args->greatest_fin_rad)
                 ? kHookAnswerAccepted
                 : kHookAnswerBadFin;
  }
  return kHookAnswerBadCommand;
}

HookAnswer hookbehCheckBounds(const HookInstruction* instruction, const HookbehArgs* args) {
  const HookAnswer vertical = checkVertical(instruction, args);
  return vertical == kHookAnswerAccepted ? checkLateral(instruction, args) : vertical;
}
