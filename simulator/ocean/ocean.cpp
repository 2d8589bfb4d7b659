// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/ocean/ocean.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace glider::simulator {

namespace {

constexpr double kFullTurn = 2 * std::numbers::pi;
constexpr double kGravity = 9.81;  // m/s2
// A wave higher than the layer below it would fold the water over.
constexpr double kHighestShareOfLayer = 0.95;

/// The wave number (rad/m) of a wave of this period over water of this depth: omega^2 = g k tanh(k
/// h), by Newton's method from the greater of the deep and the shallow limit.
double waveNumber(double period_s, double depth_m) {
  const double omega = kFullTurn / period_s;
  double k = std::max(omega * omega / kGravity, omega / std::sqrt(kGravity * depth_m));
  constexpr int kSteps = 20;
  for (int i = 0; i < kSteps; ++i) {
    const double t = std::tanh(k * depth_m);
    const double slope = kGravity * (t + k * depth_m * (1 - t * t));
    k -= (kGravity * k * t - omega * omega) / slope;
  }
  return k;
}

}  // namespace

double compression(double pressure_pa) {
  // The secant bulk modulus, Pa, and its increase with pressure. Other temperatures and salinities
  // of the sea change the density at 1000 m by 0.1 kg/m3.
  constexpr double kModulus = 2.26951e9, kIncrease = 3.37534;
  return 1 / (1 - pressure_pa / (kModulus + kIncrease * pressure_pa));
}

Ocean::Ocean(const OceanSettings& settings) : settings_(settings), bottom_(settings.bottom) {
  if (settings.swell.amplitude_m > 0) {
    swell_per_m_ = waveNumber(settings.swell.period_s, settings.bottom.depth_m);
  }
}

double Ocean::swellPressure(double z, double x, double y, double t) const {
  const SwellSettings& s = settings_.swell;
  if (s.amplitude_m == 0) {
    return 0;
  }
  const double k = swell_per_m_;
  const double h = std::max(waterDepth(x, y), z);
  const double decay = std::exp(-k * z);
  const double echo = std::exp(-2 * k * (h - z));
  const double whole = std::exp(-2 * k * h);
  const double pressure = decay * (1 + echo) / (1 + whole);
  const double motion = h > 0 ? decay * (1 - echo) / (1 - whole) : 1;
  const double along = x * std::sin(s.bearing_rad) + y * std::cos(s.bearing_rad);
  const double angle = k * along - kFullTurn / s.period_s * t;
  return s.amplitude_m * (pressure - s.followed_share * motion) * std::cos(angle);
}

Ocean::Wave Ocean::wave(double x, double t, double water_depth) const {
  const WaveSettings& w = settings_.wave;
  const double lower_layer = std::max(water_depth - settings_.thermocline_depth_m, 0.0);
  const double amplitude = std::min(w.amplitude_m, kHighestShareOfLayer * lower_layer);
  if (amplitude == 0) {
    return {};
  }
  const double waves = (t - w.start_s) / w.period_s - (w.wavelength_m > 0 ? x / w.wavelength_m : 0);
  if (w.count > 0 && (waves < 0 || waves > w.count)) {
    return {};
  }
  const double angle = kFullTurn * waves + w.phase_rad;
  return {amplitude * std::sin(angle), amplitude * std::cos(angle) * kFullTurn / w.period_s};
}

double Ocean::shape(double z, double water_depth) const {
  const double z0 = settings_.thermocline_depth_m;
  if (z <= z0) {
    return z / z0;
  }
  return water_depth > z0 ? (water_depth - z) / (water_depth - z0) : 0;
}

double Ocean::beyondFront(double x, double y) const {
  const FrontSettings& f = settings_.front;
  if (f.step_degC == 0 && f.step_salinity == 0) {
    return 0;
  }
  const double beyond = (x - f.x) * std::sin(f.bearing_rad) + (y - f.y) * std::cos(f.bearing_rad);
  return (1 + std::tanh(beyond / f.width_m)) / 2;
}

double Ocean::upperShare(double z, double x, double y, double t) const {
  const double water_depth = waterDepth(x, y);
  const double lowered = wave(x, t, water_depth).lowered * shape(z, water_depth);
  const double layer =
      (z - settings_.thermocline_depth_m - lowered) / settings_.thermocline_thickness_m;
  return (1 - std::tanh(layer)) / 2;
}

double Ocean::temperature(double z, double x, double y, double t) const {
  const double contrast = settings_.surface_temperature - settings_.bottom_temperature;
  return settings_.bottom_temperature + contrast * upperShare(z, x, y, t) +
         settings_.front.step_degC * beyondFront(x, y);
}

double Ocean::salinity(double z, double x, double y, double t) const {
  const double contrast = settings_.surface_salinity - settings_.bottom_salinity;
  const double upper = contrast == 0 ? 0 : contrast * upperShare(z, x, y, t);
  const double step = settings_.front.step_salinity;
  return std::max(0.0,
                  settings_.bottom_salinity + upper + (step == 0 ? 0 : step * beyondFront(x, y)));
}

double Ocean::density(double z, double x, double y, double t) const {
  constexpr double kPascalPerMetre = 1e4;  // as in the vehicle: 0.1 bar
  const double step = settings_.density_step;
  const double free =
      step == 0 ? settings_.density : settings_.density + step * (0.5 - upperShare(z, x, y, t));
  return free * compression(z * kPascalPerMetre);
}

Planar Ocean::current(double z, double x, double y) const {
  const Planar& top = settings_.current;
  const Planar& bottom = settings_.bottom_current;
  const double water_depth = waterDepth(x, y);
  const double share = water_depth > 0 ? std::clamp(z / water_depth, 0.0, 1.0) : 0;
  return {top.east + (bottom.east - top.east) * share,
          top.north + (bottom.north - top.north) * share};
}

double Ocean::verticalCurrent(double z, double x, double y, double t) const {
  const double water_depth = waterDepth(x, y);
  const double sinking = wave(x, t, water_depth).rate;
  return sinking == 0 ? 0 : -sinking * shape(z, water_depth);
}

double Ocean::isothermDepth(double temperature, double x, double y, double t) const {
  const double contrast = settings_.surface_temperature - settings_.bottom_temperature;
  const double step = settings_.front.step_degC * beyondFront(x, y);
  const double above_bottom = temperature - step - settings_.bottom_temperature;
  const double inner = 1 - 2 * above_bottom / contrast;
  const double z0 = settings_.thermocline_depth_m;
  const double bottom = waterDepth(x, y);
  // The depth at which the water at rest has this temperature; then the wave's shape solved for z,
  // layer by layer.
  const double rest = z0 + settings_.thermocline_thickness_m * std::atanh(inner);
  const double lowered = wave(x, t, bottom).lowered;
  const double below = bottom - z0;
  const double z = rest <= z0 - lowered ? rest / (1 - lowered / z0)
                                        : (rest + lowered * bottom / below) / (1 + lowered / below);
  return z >= 0 && z <= bottom ? z : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace glider::simulator
