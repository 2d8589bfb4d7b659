// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/hookbeh/hull.h"

#include "hooks/protocol/numbers.h"

namespace glider::hooks {
namespace {

/// With less than this share of its pump range, a vehicle may be unable to climb out of dense
/// water.
constexpr double kLeastClimbShare = 0.5;
/// m; the altimeter receives no echo from nearer.
constexpr double kLeastAltitudeM = 2;

double orUsual(double value, double usual) {
  return isFinite(value) ? value : usual;
}

}  // namespace

HookbehArgs within(const HookbehArgs& args, const Hull& hull) {
  const HookbehArgs usual;
  HookbehArgs out = args;
  out.greatest_depth_m = atMost(hull.greatest_depth_m, args.greatest_depth_m);  // NaN stays
  if (out.least_altitude_m >= 0 && out.least_altitude_m < kLeastAltitudeM) {
    out.least_altitude_m = kLeastAltitudeM;
  }
  out.shallowest_pitch_rad = between(orUsual(args.shallowest_pitch_rad, usual.shallowest_pitch_rad),
                                     hull.shallowest_pitch_rad, hull.steepest_pitch_rad);
  out.steepest_pitch_rad = between(orUsual(args.steepest_pitch_rad, usual.steepest_pitch_rad),
                                   hull.shallowest_pitch_rad, hull.steepest_pitch_rad);
  out.greatest_fin_rad =
      between(orUsual(args.greatest_fin_rad, usual.greatest_fin_rad), 0, hull.fin_rad);
  out.greatest_pump_cc =
      between(orUsual(args.greatest_pump_cc, usual.greatest_pump_cc), 0, hull.pump_cc);
  out.greatest_battery_in =
      between(orUsual(args.greatest_battery_in, usual.greatest_battery_in), 0, hull.battery_in);
  const double dive = magnitude(orUsual(args.dive_pump_cc, usual.dive_pump_cc));
  const double climb = magnitude(orUsual(args.climb_pump_cc, usual.climb_pump_cc));
  const bool whole_dive = args.dive_pump_mode == PumpMode::Autoballast;
  const bool whole_climb = args.climb_pump_mode == PumpMode::Autoballast;
  out.dive_pump_cc = whole_dive ? -hull.pump_cc : -between(dive, 0, hull.pump_cc);
  out.climb_pump_cc =
      whole_climb ? hull.pump_cc : between(climb, kLeastClimbShare * hull.pump_cc, hull.pump_cc);
  out.silence_secs = atMost(kMostSilenceSecs, args.silence_secs);
  return out;
}

}  // namespace glider::hooks
