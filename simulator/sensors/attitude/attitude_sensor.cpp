// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/sensors/attitude/attitude_sensor.h"

#include "simulator/tables/scenario_tables.h"

#include <cmath>
#include <numbers>

namespace glider::simulator {

void AttitudeSettings::read(ScenarioTables& tables) {
  tables.table("sensors", [&](Fields& f) {
    f.number("pitch_rad", pitch_rad, 0, 1);
    f.number("heading_rad", heading_rad, 0, 1);
  });
}

double AttitudeSensor::heading(double truth) {
  constexpr double kTurn = 2 * std::numbers::pi;
  const double read = truth + heading_noise_.normal(settings_.heading_rad);
  return read - kTurn * std::floor(read / kTurn);
}

}  // namespace glider::simulator
