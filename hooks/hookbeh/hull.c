// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/hookbeh/hull.h"

#include "hooks/protocol/numbers.h"

/// With less than this share of its pump range, a vehicle may be unable to climb out of dense
/// water.
static const double kLeastClimbShare = 0.5;
/// m; the altimeter receives no echo from nearer.
static const double kLeastAltitudeM = 2;

void hookbehUsualArgs(HookbehArgs* args) {
#define ARG(name, usual) args->name = usual;
#define PUMP_MODE(name, usual) args->name = kHookPumpMode##usual;
#include "hooks/hookbeh/args.def"
}

static double orUsual(double value, double usual) {
  return hookIsFinite(value) ? value : usual;
}

void hookbehWithin(const HookbehArgs* args, const HookHull* hull, HookbehArgs* out) {
  HookbehArgs usual;
  hookbehUsualArgs(&usual);
  *out = *args;
  out->greatest_depth_m = hookAtMost(hull->greatest_depth_m, args->greatest_depth_m);  // NaN stays
  if (out->least_altitude_m >= 0 && out->least_altitude_m < kLeastAltitudeM) {
    out->least_altitude_m = kLeastAltitudeM;
  }
  out->shallowest_pitch_rad =
      hookBetween(orUsual(args->shallowest_pitch_rad, usual.shallowest_pitch_rad),
                  hull->shallowest_pitch_rad, hull->steepest_pitch_rad);
  out->steepest_pitch_rad = hookBetween(orUsual(args->steepest_pitch_rad, usual.steepest_pitch_rad),
                                        hull->shallowest_pitch_rad, hull->steepest_pitch_rad);
  out->greatest_fin_rad =
      hookBetween(orUsual(args->greatest_fin_rad, usual.greatest_fin_rad), 0, hull->fin_rad);
  out->greatest_pump_cc =
      hookBetween(orUsual(args->greatest_pump_cc, usual.greatest_pump_cc), 0, hull->pump_cc);
  out->greatest_battery_in = hookBetween(
      orUsual(args->greatest_battery_in, usual.greatest_battery_in), 0, hull->battery_in);
  const double dive = hookMagnitude(orUsual(args->dive_pump_cc, usual.dive_pump_cc));
  const double climb = hookMagnitude(orUsual(args->climb_pump_cc, usual.climb_pump_cc));
  const bool whole_dive = args->dive_pump_mode == kHookPumpModeAutoballast;
  const bool whole_climb = args->climb_pump_mode == kHookPumpModeAutoballast;
  out->dive_pump_cc = whole_dive ? -hull->pump_cc : -hookBetween(dive, 0, hull->pump_cc);
  out->climb_pump_cc = whole_climb
                           ? hull->pump_cc
                           : hookBetween(climb, kLeastClimbShare * hull->pump_cc, hull->pump_cc);
  out->silence_secs = hookAtMost(kHookbehMostSilenceSecs, args->silence_secs);
  out->nap_secs = hookAtMost(kHookbehMostNapSecs, args->nap_secs);  // NaN stays: no naps
}
