// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/ocean/ocean.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace glider::simulator {

constexpr double kTurn = 2 * std::numbers::pi;

Ocean::Wave Ocean::wave(double x, double t) const {
  const WaveSettings& w = settings_.wave;
  if (w.amplitude_m == 0) {
    return {};
  }
  const double waves = (t - w.start_s) / w.period_s - (w.wavelength_m > 0 ? x / w.wavelength_m : 0);
  if (w.count > 0 && (waves < 0 || waves > w.count)) {
    return {};
  }
  const double angle = kTurn * waves + w.phase_rad;
  return {w.amplitude_m * std::sin(angle), w.amplitude_m * std::cos(angle) * kTurn / w.period_s};
}

double Ocean::shape(double z, double water_depth) const {
  const double z0 = settings_.thermocline_depth_m;
  return z <= z0 ? z / z0 : (water_depth - z) / (water_depth - z0);
}

double Ocean::temperature(double z, double x, double y, double t) const {
  const double lowered = wave(x, t).lowered * shape(z, waterDepth(x, y));
  const double layer =
      (z - settings_.thermocline_depth_m - lowered) / settings_.thermocline_thickness_m;
  const double contrast = settings_.surface_temperature - settings_.bottom_temperature;
  return settings_.bottom_temperature + contrast / 2 * (1 - std::tanh(layer));
}

double Ocean::density(double /*z*/) const {
  return settings_.density;
}

double Ocean::verticalCurrent(double z, double x, double y, double t) const {
  const double sinking = wave(x, t).rate;
  return sinking == 0 ? 0 : -sinking * shape(z, waterDepth(x, y));
}

double Ocean::waterDepth(double x, double y) const {
  if (settings_.bottom_height_m == 0) {
    return settings_.water_depth_m;
  }
  return settings_.water_depth_m -
         settings_.bottom_height_m *
             std::sin(kTurn * std::hypot(x, y) / settings_.bottom_wavelength_m);
}

double Ocean::isothermDepth(double temperature, double x, double y, double t) const {
  const double contrast = settings_.surface_temperature - settings_.bottom_temperature;
  const double inner = 1 - 2 * (temperature - settings_.bottom_temperature) / contrast;
  const double z0 = settings_.thermocline_depth_m;
  const double bottom = waterDepth(x, y);
  // The depth at which the water at rest has this temperature; then the wave's shape solved for z,
  // layer by layer.
  const double rest = z0 + settings_.thermocline_thickness_m * std::atanh(inner);
  const double lowered = wave(x, t).lowered;
  const double below = bottom - z0;
  const double z = rest <= z0 - lowered ? rest / (1 - lowered / z0)
                                        : (rest + lowered * bottom / below) / (1 + lowered / below);
  return z >= 0 && z <= bottom ? z : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace glider::simulator
