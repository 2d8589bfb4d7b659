// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/sensors/depth/depth_sensor.h"

#include "simulator/tables/scenario_tables.h"

namespace glider::simulator {

void DepthSettings::read(ScenarioTables& tables) {
  tables.table("sensors", [&](Fields& f) { f.number("depth_m", noise_m, 0, 10); });
}

}  // namespace glider::simulator
