// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/sensors/fluorometer/fluorometer.h"

#include "simulator/tables/scenario_tables.h"

#include <cmath>

namespace glider::simulator {
namespace {

constexpr InstrumentSensor kFluorometerSensors[] = {{"sci_flbbcd_chlor_units", "ug/L"}};

Patch readPatch(Fields& f) {
  f.reader().only(
      {"latitude_deg", "longitude_deg", "radius_m", "depth_m", "thickness_m", "peak_ugpl"});
  Patch patch;
  f.place(patch.x, patch.y);
  patch.radius_m = f.required("radius_m", 1, 1e6);
  patch.depth_m = f.required("depth_m", 0, 10000);
  patch.thickness_m = f.required("thickness_m", 0.1, 10000);
  patch.peak_ugpl = f.required("peak_ugpl", 0, 1000);
  return patch;
}

}  // namespace

void FluorometerSettings::read(ScenarioTables& tables) {
  tables.table("ocean", [&](Fields& f) { f.number("chlorophyll_ugpl", background_ugpl, 0, 1000); });
  tables.each("ocean", "patch", [&](Fields& f) { patches.push_back(readPatch(f)); });
  tables.table("sensors", [&](Fields& f) { f.number("chlorophyll_ugpl", noise_ugpl, 0, 100); });
  if (!patches.empty() && std::isnan(background_ugpl)) {
    background_ugpl = 0;
  }
}

double FluorometerSettings::chlorophyll(double z, double x, double y) const {
  double sum = background_ugpl;
  for (const Patch& patch : patches) {
    const double r = std::hypot(x - patch.x, y - patch.y) / patch.radius_m;
    const double h = (z - patch.depth_m) / patch.thickness_m;
    sum += patch.peak_ugpl * std::exp(-r * r - h * h);
  }
  return sum;
}

Fluorometer::Fluorometer(uint64_t seed, const Settings& settings)
    : settings_(settings), noise_(seed, kFluorometerSensors[0].name, settings.noise_ugpl) {}

std::span<const InstrumentSensor> Fluorometer::sensors() const {
  return kFluorometerSensors;
}

std::string_view Fluorometer::setting() const {
  return "`chlorophyll_ugpl` in [ocean]";
}

bool Fluorometer::carried() const {
  return !std::isnan(settings_.background_ugpl);
}

void Fluorometer::sample(const Sampling& at, std::span<double> readings) {
  readings[0] = noise_.read(settings_.chlorophyll(at.depth_m, at.x, at.y));
}

}  // namespace glider::simulator
