// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/hookbeh/hover.h"

#include "hooks/hookbeh/sub_behaviours.h"
#include "hooks/protocol/numbers.h"

// A glider of about 100 kg (with the water it moves) and 0.0098 N a cc swings with a period of 100
// s about its depth at this gain; the damping is near critical.
static const double kPumpPerMetre = 40.0;
static const double kPumpPerMetreASecond = 1000.0;
/// s; over this time a depth is smoothed: the swings of swell and the noise of a sensor are faster,
/// those of the vehicle are slower.
static const double kSmoothSecs = 6;
/// cc; the pump rests while its new volume would differ by less.
static const double kRestsCc = 25;

void hookHoverInit(HookHover* hover, double target_m) {
  hover->target_m = target_m;
  hover->read_m = hover->depth_m = hover->pump_cc = hookUnknown();
  hover->age_s = hover->rate_mps = 0;
}

/// A g-h filter with two equal time constants (a fading memory): an extrapolation of the last
/// estimate is corrected by the reading.
static void followDepth(HookHover* hover, const HookSurroundings* now, double step_s) {
  hover->age_s += step_s;
  if (!hookIsFinite(now->depth_m) || now->depth_m == hover->read_m) {
    return;  // the sensor array keeps a reading until there is a newer one
  }
  if (!hookIsFinite(hover->depth_m)) {
    hover->depth_m = now->depth_m;
    hover->rate_mps = hookIsFinite(now->depth_rate_mps) ? now->depth_rate_mps : 0;
  } else if (hover->age_s > 0) {
    const double keeps = kSmoothSecs / (kSmoothSecs + hover->age_s);
    const double off = now->depth_m - (hover->depth_m + hover->rate_mps * hover->age_s);
    hover->depth_m += hover->rate_mps * hover->age_s + (1 - keeps * keeps) * off;
    hover->rate_mps += (1 - keeps) * (1 - keeps) * off / hover->age_s;
  }
  hover->read_m = now->depth_m;
  hover->age_s = 0;
}

void hookHoverCommand(HookHover* hover, const HookSurroundings* now, double step_s,
                      const HookbehArgs* args, HookVerticalCommand* command) {
  followDepth(hover, now, step_s);
  const double depth = hookIsFinite(now->depth_m) ? hover->depth_m : now->depth_m;
  const double wanted =
      kPumpPerMetre * (depth - hover->target_m) + kPumpPerMetreASecond * hover->rate_mps;
  if (!(hookMagnitude(wanted - hover->pump_cc) <= kRestsCc)) {
    // The guard handles an unknown depth. Even so, the pump must not receive a NaN: it goes out.
    hover->pump_cc = hookAtLeast(hookAtMost(wanted, args->climb_pump_cc), args->dive_pump_cc);
  }
  hookServoCommand(0, hover->pump_cc, kHookDoingHover, command);
}
