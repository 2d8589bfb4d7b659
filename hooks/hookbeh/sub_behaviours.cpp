// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/hookbeh/sub_behaviours.h"

#include "hooks/protocol/numbers.h"

namespace glider::hooks {
namespace {

constexpr double kUsualPitchRad = 0.4538;

}  // namespace

VerticalCommand SurfaceNow::command(const HookbehArgs& args) const {
  return {usualPitch(args), args.climb_pump_cc, Doing::Surface};
}

/// What its pitch will be depends on a trim that hookbeh does not know. The guards assume a
/// dive whose pitch is the share of the battery's way, and a vehicle that is never driven up.
VerticalCommand FixedActuators::command(const HookbehArgs& args) const {
  const double share = args.greatest_battery_in > 0
                           ? between(magnitude(battery_in) / args.greatest_battery_in, 0, 1)
                           : 0;
  const double steep = atLeast(share * args.steepest_pitch_rad, args.shallowest_pitch_rad);
  return {dives() ? -steep : 0, pump_cc, Doing::Actuators, PitchMode::Battery, battery_in};
}

VerticalCommand climbNow(Doing doing, const HookbehArgs& args, const Hull& hull) {
  return {usualPitch(args), hull.pump_cc, doing};
}

double usualPitch(const HookbehArgs& args) {
  return between(kUsualPitchRad, args.shallowest_pitch_rad, args.steepest_pitch_rad);
}

}  // namespace glider::hooks
