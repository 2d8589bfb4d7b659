// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/port_files/mission_port.h"

#include "ir/text/print.h"

#include <fmt/format.h>

#include <string>
#include <vector>

namespace glider::slocum {

support::Result<PortPlan> planFor(const compiler::Optimised& mission, const PortChoice& choice) {
  std::vector<uint16_t> sensors;
  for (const ir::Sensor& sensor : mission.mission.sensors) {
    if (sensor.isOfVehicle()) {
      sensors.push_back(sensor.id);
    }
  }
  const std::string content =
      fmt::format("{}{}{}{}", ir::print(mission.mission), choice.greatest_depth_m,
                  static_cast<int>(choice.release), choice.least_altitude_m);
  return planPort(mission.mission.name, content, mission.platform(), sensors, choice);
}

}  // namespace glider::slocum
