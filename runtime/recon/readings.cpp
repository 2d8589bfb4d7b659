// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/recon/readings.h"

#include "runtime/numbers/numbers.h"

namespace glider::runtime::recon {
namespace {

double radians(double degrees) {
  return degrees / kDegreesPerRadian;
}

/// In [0, 2 pi); unknown stays so, and what is not between -360 and 360 degrees is unknown.
double turnOf(double degrees) {
  constexpr double kTurn = 360;
  const double positive = degrees < 0 ? degrees + kTurn : degrees;
  return positive == kTurn                   ? 0.0
         : positive >= 0 && positive < kTurn ? radians(positive)
                                             : unknown();
}

}  // namespace

Readings::Readings() {
  for (double& value : values_) {
    value = unknown();
  }
}

void Readings::set(Reading reading, double value) {
  if (isFinite(value)) {
    values_[index(reading)] = value;
    fresh_[index(reading)] = true;
  }
}

bool Readings::takeReport(Reading reading, double* value) {
  const bool fresh = fresh_[index(reading)];
  fresh_[index(reading)] = false;
  *value = values_[index(reading)];
  return fresh;
}

/// A place that is not known any more must not be steered by. After a clock was set back its age is
/// not known either.
void Readings::takePlace(const hooks::recon::State& state, double clock_s) {
  if (isFinite(state.latitude_deg) && isFinite(state.longitude_deg)) {
    here_ = {state.latitude_deg, state.longitude_deg};
    here_s_ = clock_s;
    set(Reading::Latitude, ddmmOf(state.latitude_deg));
    set(Reading::Longitude, ddmmOf(state.longitude_deg));
  } else if (const double age_s = clock_s - here_s_; !(age_s >= 0 && age_s < kOldSecs)) {
    here_ = Place();
  }
}

void Readings::take(const hooks::recon::State& state, double clock_s) {
  set(Reading::Clock, clock_s);
  takePlace(state, clock_s);
  depth_now_ = state.depth_m;
  set(Reading::Depth, state.depth_m);
  set(Reading::DepthGoal, state.depth_goal_m);
  set(Reading::Altitude, state.altitude_m);
  set(Reading::Pitch, radians(state.pitch_deg));
  set(Reading::Roll, radians(state.roll_deg));
  set(Reading::Rpm, state.rpm);
  set(Reading::RpmGoal, state.rpm_goal);
  set(Reading::Speed, state.speed_m_s);
  set(Reading::Heading, turnOf(state.heading_deg));
  set(Reading::HeadingRate, radians(state.heading_rate_deg_s));
  set(Reading::HeadingGoal, turnOf(state.heading_goal_deg));
  set(Reading::Mode, state.mode);
  set(Reading::Leg, state.leg);
}

void Readings::take(const hooks::recon::Ctd& ctd) {
  set(Reading::Temperature, ctd.temperature_degC);
  set(Reading::Salinity, ctd.salinity);
  set(Reading::CtdDepth, ctd.depth_m);
  set(Reading::SoundSpeed, ctd.sound_speed_m_s);
}

}  // namespace glider::runtime::recon
