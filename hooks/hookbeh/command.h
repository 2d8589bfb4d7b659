// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#ifndef GLIDER_HOOKS_HOOKBEH_COMMAND_H
#define GLIDER_HOOKS_HOOKBEH_COMMAND_H

#include "hooks/hookbeh/doing.h"

/// How the heading is commanded, and what keeps the pitch: the servo, or a fixed place of the
/// battery. In C both are numbers of one byte, with values as kHookHeadingModeFin.
#ifdef __cplusplus
enum class HookHeadingMode : uint8_t { CentreFin, Heading, Waypoint, Fin };
enum class HookPitchMode : uint8_t { Servo, Battery };
#else
typedef uint8_t HookHeadingMode;
enum {
  kHookHeadingModeCentreFin,
  kHookHeadingModeHeading,
  kHookHeadingModeWaypoint,
  kHookHeadingModeFin
};
typedef uint8_t HookPitchMode;
enum { kHookPitchModeServo, kHookPitchModeBattery };
#endif

GLIDER_HOOKS_BEGIN

/// The pitch and pump that a sub-behaviour commands in one cycle.
typedef struct HookVerticalCommand {
  double pitch_rad GLIDER_IS(0);  ///< nose up positive; of a battery position: what the guards
                                  ///< assume
  double pump_cc GLIDER_IS(0);    ///< positive lifts
  HookDoing doing GLIDER_IS(HookDoing::Nothing);
  HookPitchMode pitch_mode GLIDER_IS(HookPitchMode::Servo);
  double battery_in GLIDER_IS(0);  ///< positive lowers the nose
} HookVerticalCommand;

/// The heading or fin commanded in one cycle.
typedef struct HookLateralCommand {
  HookHeadingMode mode;
  double heading_rad;
  double latitude_ddmm;
  double longitude_ddmm;
  double fin_rad;  ///< positive to turn to starboard
} HookLateralCommand;

/// What the vehicle knows about its own situation in one cycle; NaN for unknown.
typedef struct HookSurroundings {
  double depth_m GLIDER_IS(0);
  double depth_rate_mps GLIDER_IS(0);  ///< positive when sinking
  double altitude_m GLIDER_IS(0);
  double ctd_depth_m GLIDER_IS(0);  ///< from the pressure of the CTD
  double latitude_ddmm GLIDER_IS(0);
  double longitude_ddmm GLIDER_IS(0);
} HookSurroundings;

GLIDER_HOOKS_END

#ifdef __cplusplus
namespace glider::hooks {
using HeadingMode = ::HookHeadingMode;
using PitchMode = ::HookPitchMode;
using VerticalCommand = ::HookVerticalCommand;
using Surroundings = ::HookSurroundings;
}  // namespace glider::hooks
#endif

#endif
