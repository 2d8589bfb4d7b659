// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#ifndef GLIDER_HOOKS_HOOKBEH_HULL_H
#define GLIDER_HOOKS_HOOKBEH_HULL_H

#include "hooks/hookbeh/args.h"

GLIDER_HOOKS_BEGIN

/// The limits of the hull: the constants GLIDER_HULL_… of the header that is generated from the
/// vehicle's platform file. They are fixed when hookbeh is built into the vehicle's software;
/// b_args and instructions may narrow them, never widen them.
typedef struct HookHull {
  double greatest_depth_m GLIDER_IS(0);
  double steepest_pitch_rad GLIDER_IS(0);    ///< magnitude
  double shallowest_pitch_rad GLIDER_IS(0);  ///< flatter than this it does not glide
  double vertical_rate_m_s GLIDER_IS(0);     ///< the fastest it sinks or climbs
  double pump_cc GLIDER_IS(0);               ///< in either direction
  double fin_rad GLIDER_IS(0);               ///< to either side; 0: there is no fin to command
  double battery_in GLIDER_IS(0);  ///< of the pitch battery, to either side; 0: there is none to
                                   ///< command
} HookHull;

/// s; the longest wait for an SBC. Meanwhile the vehicle follows the last instruction of an SBC
/// that may be dead.
enum { kHookbehMostSilenceSecs = 600 };
/// s; the longest that hookprog may vouch for an SBC that sleeps.
enum { kHookbehMostNapSecs = 3660 };

/// Into `out` the `args` narrowed to the hull, each to the safer of the two. Pump, battery, pitch
/// and fin values that are not numbers are replaced by their defaults; the sign of a pump value
/// with the wrong sign is reversed, and one too weak to bring the vehicle up is strengthened. A
/// greatest depth or least altitude that is NaN stays NaN: a broken limit.
void hookbehWithin(const HookbehArgs* args, const HookHull* hull, HookbehArgs* out);

GLIDER_HOOKS_END

#ifdef __cplusplus
namespace glider::hooks {
using Hull = ::HookHull;
inline constexpr double kMostSilenceSecs = kHookbehMostSilenceSecs;
inline constexpr double kMostNapSecs = kHookbehMostNapSecs;
inline HookbehArgs within(const HookbehArgs& args, const Hull& hull) {
  HookbehArgs out;
  hookbehWithin(&args, &hull, &out);
  return out;
}
}  // namespace glider::hooks
#endif

#endif
