// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/sensors/altimeter/altimeter.h"

#include "simulator/tables/scenario_tables.h"

#include <limits>

namespace glider::simulator {

constexpr double kLeast = 2, kLeastDepth = 2;  // m

void AltimeterSettings::read(ScenarioTables& tables) {
  tables.table("sensors", [&](Fields& f) { f.number("altitude_m", noise_m, 0, 100); });
  tables.part("sensors", "altimeter", [&](Fields& f) {
    f.reader().only({"range_m", "dropout"});
    f.number("range_m", range_m, 2, 100);
    f.number("dropout", dropout, 0, 1);
  });
  given = tables.has("sensors", "altimeter");
}

double Altimeter::altitude(double depth_m, double water_depth_m) {
  const double read = water_depth_m - depth_m + noise_.normal(settings_.noise_m);
  const bool lost = dropout_.uniform() < settings_.dropout;
  const bool echo = !lost && depth_m > kLeastDepth && read >= kLeast && read <= settings_.range_m;
  return echo ? read : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace glider::simulator
