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

VerticalCommand climbNow(Doing doing, const HookbehArgs& args, const Hull& hull) {
  return {usualPitch(args), hull.pump_cc, doing};
}

double usualPitch(const HookbehArgs& args) {
  return between(kUsualPitchRad, args.shallowest_pitch_rad, args.steepest_pitch_rad);
}

}  // namespace glider::hooks
