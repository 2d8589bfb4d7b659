// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/hookbeh/sub_behaviours.h"

#include "hooks/protocol/numbers.h"

namespace glider::hooks {
namespace {

constexpr double kUsualPitchRad = 0.4538;
// A glider of about 100 kg (with the water it moves) and 0.0098 N a cc swings with a period of 100
// s about its depth at this gain; the damping is near critical.
constexpr double kPumpPerMetre = 40.0;
constexpr double kPumpPerMetreASecond = 1000.0;

}  // namespace

VerticalCommand Hover::command(const Surroundings& now, const HookbehArgs& args) const {
  const double rate = isFinite(now.depth_rate_mps) ? now.depth_rate_mps : 0;
  const double wanted = kPumpPerMetre * (now.depth_m - target_m) + kPumpPerMetreASecond * rate;
  // The guard handles an unknown depth. Even so, the pump must not receive a NaN: it goes out.
  const double pump = atLeast(atMost(wanted, args.climb_pump_cc), args.dive_pump_cc);
  return {0, pump, "hover"};
}

VerticalCommand SurfaceNow::command(const HookbehArgs& args) const {
  return {usualPitch(args), args.climb_pump_cc, "surface"};
}

VerticalCommand climbNow(const char* doing, const HookbehArgs& args, const Hull& hull) {
  return {usualPitch(args), hull.pump_cc, doing};
}

double usualPitch(const HookbehArgs& args) {
  return between(kUsualPitchRad, args.shallowest_pitch_rad, args.steepest_pitch_rad);
}

}  // namespace glider::hooks
