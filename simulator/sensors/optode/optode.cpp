// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/sensors/optode/optode.h"

#include "simulator/tables/scenario_tables.h"

#include <cmath>

namespace glider::simulator {

constexpr InstrumentSensor kOptodeSensors[] = {{"sci_oxy4_oxygen", "uM"}};

void OptodeSettings::read(ScenarioTables& tables) {
  tables.table("ocean", [&](Fields& f) {
    f.together("surface_oxygen_uM", "bottom_oxygen_uM");
    f.number("surface_oxygen_uM", surface_uM, 0, 1000);
    f.number("bottom_oxygen_uM", bottom_uM, 0, 1000);
  });
  tables.table("sensors", [&](Fields& f) { f.number("oxygen_uM", noise_uM, 0, 1000); });
}

Optode::Optode(uint64_t seed, const Settings& settings)
    : settings_(settings), noise_(seed, kOptodeSensors[0].name, settings.noise_uM) {}

std::span<const InstrumentSensor> Optode::sensors() const {
  return kOptodeSensors;
}

std::string_view Optode::setting() const {
  return "`surface_oxygen_uM` and `bottom_oxygen_uM` in [ocean]";
}

bool Optode::carried() const {
  return !std::isnan(settings_.surface_uM);
}

void Optode::sample(const Sampling& at, std::span<double> readings) {
  const double contrast = settings_.surface_uM - settings_.bottom_uM;
  const double above = at.ocean.upperShare(at.depth_m, at.x, at.y, at.time_s);
  readings[0] = noise_.read(settings_.bottom_uM + contrast * above);
}

}  // namespace glider::simulator
