// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/sensors/ctd/ctd.h"

#include "simulator/ocean/seawater.h"

#include <algorithm>
#include <cmath>

namespace glider::simulator {

constexpr double kPeriod = 1;  // s between readings
constexpr double kMetresPerBar = 10;
constexpr InstrumentSensor kCtdSensors[] = {
    {"sci_water_temp", "degC"}, {"sci_water_cond"}, {"sci_water_pressure"}};

Ctd::Ctd(uint64_t seed, const CtdSettings& settings)
    : settings_(settings),
      temperature_noise_(seed, "sci_water_temp"),
      conductivity_noise_(seed, "sci_water_cond"),
      dropout_(seed, "ctd dropout"),
      depth_noise_(seed, "ctd depth"),
      repeat_(seed, "ctd repeat") {}

std::span<const InstrumentSensor> Ctd::sensors() const {
  return kCtdSensors;
}

void Ctd::sample(const Sampling& at, std::span<double> readings) {
  const auto water = [&](double depth_m) {
    return Water{at.ocean.temperature(depth_m, at.x, at.y, at.time_s),
                 at.ocean.salinity(depth_m, at.x, at.y, at.time_s)};
  };
  const double swell = at.ocean.swellPressure(at.depth_m, at.x, at.y, at.time_s);
  if (const auto reading = read(water, at.depth_m, at.time_s, swell)) {
    readings[0] = reading->temperature_degC;
    readings[1] = reading->conductivity;
    readings[2] = reading->depth_m / kMetresPerBar;
  }
}

void Ctd::noteClimb(double depth_m, double now_s) {
  const StaleClimbs& stale = settings_.stale_climbs;
  const bool was_climbing = turns_.climbing();
  turns_.note(depth_m, now_s);
  if (turns_.climbing() && !was_climbing) {
    stale_climb_ =
        stale.on && now_s >= stale.after_s && (stale.count == 0 || stale_climbs_ < stale.count);
    stale_climbs_ += stale_climb_ ? 1 : 0;
  }
  stale_climb_ = stale_climb_ && turns_.climbing();
}

double Ctd::renewed(double now_s) const {
  const auto holds = [now_s](const StaleWater& s) { return now_s >= s.from_s && now_s < s.to_s; };
  if (std::ranges::any_of(settings_.stale_water, holds)) {
    return 0;
  }
  if (!stale_climb_) {
    return 1;
  }
  const StaleClimbs& stale = settings_.stale_climbs;
  if (now_s - turns_.since() < stale.frozen_s) {
    return 0;
  }
  return stale.flush_s > 0 ? 1 - std::exp(-kPeriod / stale.flush_s) : 1;
}

void Ctd::flush(const Water& outside, double depth_m, double now_s) {
  noteClimb(depth_m, now_s);
  const double share = renewed(now_s);
  if (share == 1 || !in_duct_) {
    in_duct_ = outside;
  } else {
    in_duct_->temperature_degC += (outside.temperature_degC - in_duct_->temperature_degC) * share;
    in_duct_->salinity += (outside.salinity - in_duct_->salinity) * share;
  }
}

double Ctd::conductivityInDuct(double dbar) {
  if (!std::isnan(settings_.conductivity)) {
    return settings_.conductivity;
  }
  const double noise = conductivity_noise_.normal(settings_.noise_Spm);
  return std::max(0.0,
                  conductivityOf(in_duct_->salinity, in_duct_->temperature_degC, dbar) + noise);
}

std::optional<Ctd::Reading> Ctd::due(double now_s) {
  std::optional<Reading> newest;
  while (!on_their_way_.empty() && on_their_way_.front().time_s + settings_.late_s <= now_s) {
    newest = on_their_way_.front().reading;
    on_their_way_.pop_front();
  }
  return newest;
}

std::optional<Ctd::Reading> Ctd::read(const Column& water, double depth_m, double now_s,
                                      double swell_m) {
  const double noise = temperature_noise_.normal(settings_.noise_degC);
  const double off = depth_noise_.normal(settings_.non_monotonic_m);
  const bool lost = dropout_.uniform() < settings_.dropout;
  const bool repeated = repeat_.uniform() < settings_.repeat_fraction;
  flush(water(std::max(0.0, depth_m + off)), depth_m, now_s);
  if (!lost) {
    const double pressed_m = depth_m + swell_m;  // as many decibars
    on_their_way_.push_back(
        {now_s, {in_duct_->temperature_degC + noise, pressed_m, conductivityInDuct(pressed_m)}});
  }
  const std::optional<Reading> now = due(now_s);
  if (!now || !repeated || !given_) {
    given_ = now ? now : given_;
    return now;
  }
  return given_;
}

}  // namespace glider::simulator
