// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/hookbeh/args.h"

namespace glider::hooks {

/// What the hull can bear: the constants GLIDER_HULL_… of the header that is generated from the
/// vehicle's platform file. Who builds hookbeh into the vehicle's software fixes it; b_args and
/// instructions may narrow it, never widen it.
struct Hull {
  double greatest_depth_m = 0;
  double steepest_pitch_rad = 0;    ///< magnitude
  double shallowest_pitch_rad = 0;  ///< flatter than this it does not glide
  double vertical_rate_m_s = 0;     ///< the fastest it sinks or climbs
  double pump_cc = 0;               ///< to either side
};

/// A depth outside these, m, is no reading of a depth sensor: above the surface, or far below what
/// the hull survives.
inline constexpr double kHighestDepthM = -5;
inline constexpr double kDeepestShare = 1.5;

/// `args` narrowed to the hull, each to the safer of the two. Pump and pitch that are no numbers
/// count as their defaults; a pump with the wrong sign is turned round, and one too weak to bring
/// the vehicle up is strengthened. A greatest depth or least altitude that is NaN stays NaN: a
/// broken limit.
HookbehArgs within(const HookbehArgs& args, const Hull& hull);

}  // namespace glider::hooks
