// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/hookbeh/args.h"

namespace glider::hooks {

/// The limits of the hull: the constants GLIDER_HULL_… of the header that is generated from the
/// vehicle's platform file. They are fixed when hookbeh is built into the vehicle's software;
/// b_args and instructions may narrow them, never widen them.
struct Hull {
  double greatest_depth_m = 0;
  double steepest_pitch_rad = 0;    ///< magnitude
  double shallowest_pitch_rad = 0;  ///< flatter than this it does not glide
  double vertical_rate_m_s = 0;     ///< the fastest it sinks or climbs
  double pump_cc = 0;               ///< in either direction
  double fin_rad = 0;               ///< to either side; 0: there is no fin to command
  double battery_in = 0;  ///< of the pitch battery, to either side; 0: there is none to command
};

/// m; a depth outside this range is not a valid reading of a depth sensor: it is above the surface,
/// or far below what the hull survives.
inline constexpr double kHighestDepthM = -5;
inline constexpr double kDeepestShare = 1.5;

/// s; the longest wait for an SBC. Meanwhile the vehicle follows the last instruction of an SBC
/// that may be dead.
inline constexpr double kMostSilenceSecs = 600;

/// `args` narrowed to the hull, each to the safer of the two. Pump, battery, pitch and fin values
/// that are not numbers are replaced by their defaults; the sign of a pump value with the wrong
/// sign is reversed, and one too weak to bring the vehicle up is strengthened. A greatest depth or
/// least altitude that is NaN stays NaN: a broken limit.
HookbehArgs within(const HookbehArgs& args, const Hull& hull);

}  // namespace glider::hooks
