// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/sensors/gps/gps.h"

#include "simulator/tables/scenario_tables.h"

#include <cmath>
#include <numbers>

namespace glider::simulator {

constexpr double kAntennaDepth = 0.3;  // m

void GpsSettings::read(ScenarioTables& tables) {
  tables.table("sensors", [&](Fields& f) { f.number("gps_m", noise_m, 0, 10000); });
}

std::optional<Gps::Fix> Gps::fix(double x, double y, double depth_m, double now_s) {
  if (depth_m > kAntennaDepth) {
    surfaced_s_ = now_s;
    return std::nullopt;
  }
  if (now_s - surfaced_s_ < kFirstFix) {
    return std::nullopt;
  }
  const double east = noise_.normal(sd_);
  return Fix{x + east, y + noise_.normal(sd_)};
}

double Gps::variation(double declination_rad) {
  constexpr double kTenth = std::numbers::pi / 1800;
  return -std::round(declination_rad / kTenth) * kTenth;
}

}  // namespace glider::simulator
